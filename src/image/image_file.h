// SPDX-License-Identifier: MIT
//
// Reads image files of any kind that OpenImageIO knows.
#pragma once

#include <filesystem>
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

}  // namespace edgecase
