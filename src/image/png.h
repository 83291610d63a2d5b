// SPDX-License-Identifier: MIT
//
// Writes PNG files. OpenImageIO does the work (image/image_library.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace edgecase {

struct ImageView {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgba;  // straight alpha, row by row from the bottom
};

// Writes an 8-bit RGBA PNG with every pixel enlarged to scale x scale (1 to 64). The picture's top
// row comes first in the file: this, and reading (image/image_file.h), are the places where y is
// flipped. Returns an error sentence, empty on success.
std::string write_png(const std::filesystem::path& path, const ImageView& image, int scale);

}  // namespace edgecase
