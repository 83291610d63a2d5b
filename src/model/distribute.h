// SPDX-License-Identifier: MIT
//
// Sorting by a number that is small: in time linear in the items and in the numbers.
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace edgecase {

// Sorts the items by index_of(item), which is below `count`; those of one index stay in order.
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
