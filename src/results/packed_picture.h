// SPDX-License-Identifier: MIT
//
// Pictures and numbers per pixel in a results file, read into the memory that their runs take: a
// picture of one colour is one run, however large it is.
//
// A picture is stored as differences: from each byte its left and lower neighbours are subtracted,
// and the lower left one is added, each 0 beyond the border, all modulo 256. For a flat or evenly
// shaded area nearly all differences are zero, and the file's compression (TextPacker) makes them
// very small.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/packed_words.h"

namespace edgecase {

// RGBA8, bottom row first, rows of `width` pixels.
std::string packed_picture(const std::vector<std::uint8_t>& pixels, int width);

// All below throw std::runtime_error for any other text.

// The inverse, for `height` rows of a target or of all its samples.
PackedWords to_picture(std::string_view text, int width, int height);

// The inverse of packed_words() (results/packed_text.h), for `size` words.
PackedWords to_packed_words(std::string_view text, std::size_t size);

// The exclusive or of `size` words with as many others; where those are not as many, the words.
// The words of pixels are RRGGBBAA as numbers, and RGBA as bytes in memory.
enum class WordsAre { numbers, pixels };
PackedWords to_difference(std::string_view text, std::size_t size, const PackedWords& others,
                          WordsAre kind);

}  // namespace edgecase
