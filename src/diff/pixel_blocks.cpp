// SPDX-License-Identifier: MIT
#include "diff/pixel_blocks.h"

#include <algorithm>
#include <cstring>

namespace edgecase {
namespace {

constexpr std::size_t kPixel = 4;  // bytes
// Two of them lie in the first level of every cache.
constexpr std::size_t kBlock = 4096;

// Pixels as words, copied so that neither side need be aligned; the copies cost nothing.
std::size_t count_words(const std::uint8_t* a, const std::uint8_t* b, std::size_t pixels) {
  // As wide as a word: the sum of a block needs no more, and the compiler keeps lanes of one width.
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    std::uint32_t own = 0;
    std::uint32_t other = 0;
    std::memcpy(&own, a + kPixel * i, kPixel);
    std::memcpy(&other, b + kPixel * i, kPixel);
    count += own == other ? 1 : 0;
  }
  return count;
}

}  // namespace

std::size_t count_same_pixels(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
  const std::size_t bytes = std::min(a.size(), b.size()) / kPixel * kPixel;
  std::size_t count = 0;
  for (std::size_t at = 0; at < bytes; at += kBlock) {
    const std::size_t length = std::min(kBlock, bytes - at);
    const bool is_same = std::memcmp(a.data() + at, b.data() + at, length) == 0;
    count += is_same ? length / kPixel : count_words(a.data() + at, b.data() + at, length / kPixel);
  }
  return count;
}

}  // namespace edgecase
