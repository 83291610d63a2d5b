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
  // the file's own numbers, including infinities. Unassociated alpha, if the file declares it,
  // stays so; colours are not converted.
  std::vector<float> rgba;
  std::string error;  // a sentence's end, such as "it has 5 channels"; empty exactly on success
};

// Refuses a file with more than `largest` pixels along a side before reading its pixels. Never
// throws because of the file's content.
ImageFile read_image(const std::filesystem::path& path, int largest);

struct ImageView {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgba;  // straight alpha, row by row from the bottom
};

// Writes an 8-bit RGBA PNG with every pixel enlarged to scale x scale (1 to 64). The file starts
// with the top row: only here and in read_image is y flipped. Returns an error sentence, empty on
// success.
std::string write_png(const std::filesystem::path& path, const ImageView& image, int scale);

// OpenImageIO is in a separate library. Loading it takes 200 ms and 128 MiB, which most commands do
// not need, so it is opened when the first file is read or written.

// A function of the library beside the running program, or null with `error` set. The library stays
// open.
void* find_image_function(const char* symbol, std::string& error);

}  // namespace edgecase
