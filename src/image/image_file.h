// SPDX-License-Identifier: MIT
//
// Reads image files of any kind that OpenImageIO knows, and writes PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace edgecase {

struct ImageFile {
  int width = 0;   // pixels
  int height = 0;  // pixels
  int bits = 0;    // of a component: 8 or 16, unsigned; 32, floating point of 16 or 32 bits
  // Red, green, blue and alpha of each pixel, row by row from the bottom: 0 to 255, 0 to 65535, or
  // what the file has, infinite numbers included. Alpha is not multiplied in where the file says
  // that it is not; colours are not converted.
  std::vector<float> rgba;
  std::string error;  // a sentence's end, such as "it has 5 channels"; empty exactly on success
};

// A file with more than `largest` pixels along a side is refused before they are read. Never
// throws for what the file holds.
ImageFile read_image(const std::filesystem::path& path, int largest);

struct ImageView {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgba;  // straight alpha, row by row from the bottom
};

// Writes an 8-bit RGBA PNG with every pixel enlarged to scale x scale (1 to 64). The picture's top
// row comes first in the file: this, and reading, are the places where y is flipped. Returns an
// error sentence, empty on success.
std::string write_png(const std::filesystem::path& path, const ImageView& image, int scale);

// The library of its own that holds OpenImageIO. Loading it costs 200 ms and 128 MiB that most
// commands have no use for, so it is opened when the first file is read or written.

// A function of the library beside the running program, or null with `error` set. The library stays
// open.
void* find_image_function(const char* symbol, std::string& error);

}  // namespace edgecase
