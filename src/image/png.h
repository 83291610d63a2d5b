// SPDX-License-Identifier: MIT
//
// Image files. OpenImageIO does the work, in a library of its own that is opened when the first
// file is written: loading it costs 200 ms and 128 MiB that most commands have no use for.
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
// row comes first in the file: this is the one place where y is flipped. Returns an error sentence,
// empty on success.
std::string write_png(const std::filesystem::path& path, const ImageView& image, int scale);

}  // namespace edgecase
