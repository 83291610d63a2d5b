// SPDX-License-Identifier: MIT
//
// The C interface between image/*.cpp and the library that holds OpenImageIO.
#pragma once

#include <cstddef>
#include <cstdint>

namespace edgecase {

inline constexpr const char* kImageLibrary = "libedgecase_image_io.so";
inline constexpr const char* kWriteImageSymbol = "edgecase_write_image";
inline constexpr const char* kReadImageSymbol = "edgecase_read_image";

// Writes RGBA8 pixels, top row first. Returns 0, or 1 with a sentence in `error`.
using WriteImageFunction = int(const char* path, int width, int height, const std::uint8_t* rgba,
                               char* error, std::size_t error_size);

struct ImageHeader {
  int width = 0;   // pixels
  int height = 0;  // pixels
  int bits = 0;    // of a component: 8 or 16, unsigned, or 32, floating point of 16 or 32 bits
};

// Reads a file's header and, if `rgba` is not null, 4 * width * height numbers, top row first, not
// premultiplied: 0 to 255, 0 to 65535, or floating point as in the file. Grey becomes red, green
// and blue; missing alpha becomes the largest value (1 for floating point). With `rgba`, `header`
// must have been read from the same file. Returns 0, or 1 with a sentence.
using ReadImageFunction = int(const char* path, ImageHeader* header, float* rgba, char* error,
                              std::size_t error_size);

}  // namespace edgecase
