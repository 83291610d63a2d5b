// SPDX-License-Identifier: MIT
//
// The C interface between image/png.cpp and the library that holds OpenImageIO.
#pragma once

#include <cstddef>
#include <cstdint>

namespace edgecase {

inline constexpr const char* kImageLibrary = "libedgecase_image_io.so";
inline constexpr const char* kWriteImageSymbol = "edgecase_write_image";

// Writes RGBA8 pixels, top row first. Returns 0, or 1 with a sentence in `error`.
using WriteImageFunction = int(const char* path, int width, int height, const std::uint8_t* rgba,
                               char* error, std::size_t error_size);

}  // namespace edgecase
