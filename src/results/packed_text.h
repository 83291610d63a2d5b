// SPDX-License-Identifier: MIT
//
// Packed text: how a results file keeps pictures, numbers per pixel and places.
//
// Words are 32 bits each, in hexadecimal digits without leading zeros, with a space between them. A
// word that stands N times in a row is "WORD*N". The word of a pixel is RRGGBBAA.
//
// A picture is told by what is left of each byte when its neighbours are taken away: the one on the
// left and the one below are subtracted, the one below on the left is added, each 0 beyond the
// border, all modulo 256. What is left of a flat or evenly shaded area is nearly all zero, which
// the compression of the file (results/packed_stream.h) makes nearly nothing of.
//
// Places are pixels, each as often as something is found there, in the order in which they are
// read: by row from the bottom, then by column. "yN" begins row N. "S+N*T" skips S pixels of the
// row, from the last one named or the row's begin; then N neighbours are named, each T times. "+1"
// and "*1" are left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/verdict.h"

namespace edgecase {

std::string packed_words(const std::vector<std::uint32_t>& words);
// The inverse, for `size` words. Throws std::runtime_error for anything else.
std::vector<std::uint32_t> to_words(std::string_view text, std::size_t size);

// RGBA8, bottom row first, rows of `width` pixels.
std::string packed_picture(const std::vector<std::uint8_t>& pixels, int width);
// The inverse, for `height` rows. Throws std::runtime_error for anything else.
std::vector<std::uint8_t> to_picture(std::string_view text, int width, int height);

// Bytes as words, four at a time, and the inverse.
std::vector<std::uint32_t> words_of(const std::vector<std::uint8_t>& bytes);
std::vector<std::uint8_t> bytes_of(const std::vector<std::uint32_t>& words);

// The primitives of places are not told: they come back as -1.
std::string packed_places(std::vector<ValueAggregate::Place> places);
// The inverse. Throws std::runtime_error for anything else, and for places beyond the largest
// target.
std::vector<ValueAggregate::Place> to_places(std::string_view text);

}  // namespace edgecase
