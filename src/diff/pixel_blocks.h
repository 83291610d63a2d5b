// SPDX-License-Identifier: MIT
//
// Pictures held against each other block by block: most blocks of most pictures are the same, which
// memcmp says as fast as memory can be read, and only the others are looked at pixel by pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace edgecase {

// How many pixels of two RGBA8 pictures are the same in all four bytes; of pictures of different
// sizes, pixels that one of them lacks differ.
std::size_t count_same_pixels(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b);

}  // namespace edgecase
