// SPDX-License-Identifier: MIT
//
// Lists of fragments: comparison to the bit, and sorting by small numbers.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "model/rendering.h"

namespace edgecase {

// Comparison to the bit: NaN equals itself, and 0 differs from -0.
inline std::uint64_t bit_pattern(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

// Whether they cover the same samples of one pixel, for one primitive.
inline bool cover_alike(const Fragment& a, const Fragment& b) {
  return a.x == b.x && a.y == b.y && a.primitive == b.primitive && a.coverage == b.coverage;
}

// Whether they have the same depth and colour.
inline bool have_equal_values(const Fragment& a, const Fragment& b) {
  return bit_pattern(a.depth) == bit_pattern(b.depth) &&
         std::ranges::equal(a.color, b.color, {}, bit_pattern, bit_pattern);
}

// Sorts the items by index_of(item), which is below `count`, in linear time and stably.
template <class Item, class IndexOf>
void distribute(std::vector<Item>& items, std::size_t count, IndexOf index_of) {
  std::vector<std::size_t> first(count + 1);
  for (const Item& item : items) ++first[index_of(item) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[first[index_of(item)]++] = item;
  items = std::move(sorted);
}

}  // namespace edgecase
