// SPDX-License-Identifier: MIT
//
// What two fragments have in common, to the bit.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "model/rendering.h"

namespace edgecase {

// NaN equals itself here, and 0 is not -0.
inline std::uint64_t bits_of(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

// Do they cover the same samples of one pixel, for one primitive?
inline bool cover_alike(const Fragment& a, const Fragment& b) {
  return a.x == b.x && a.y == b.y && a.primitive == b.primitive && a.coverage == b.coverage;
}

// Have they one depth and one colour?
inline bool have_equal_values(const Fragment& a, const Fragment& b) {
  return bits_of(a.depth) == bits_of(b.depth) &&
         std::ranges::equal(a.color, b.color, {}, bits_of, bits_of);
}

}  // namespace edgecase
