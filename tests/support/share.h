// SPDX-License-Identifier: MIT
//
// How much of its scenes an exhaustive or random test asks.
//
// EDGECASE_SHARE=I/N, with 1 <= I <= N, asks the I-th of N shares; without it a test asks all. The
// quick tier runs one share of each test, the full tier runs all shares of it: tests/tiers.cmake.
// Every share is the same scenes each time, and a test program prints which one it asks.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>

namespace edgecase {

// The `number`-th of `count` shares; `number` counts from 0.
struct Share {
  std::uint64_t number = 0;
  std::uint64_t count = 1;
};

// The share of this process. Ends the program with exit code 2 where EDGECASE_SHARE is malformed.
const Share& share();

// How many of `all` random scenes are in this share: the shares together have at least `all`.
template <std::integral T>
T share_of(T all) {
  const T count = static_cast<T>(std::min<std::uint64_t>(share().count, static_cast<std::uint64_t>(all)));
  return count == 0 ? all : static_cast<T>((all + count - 1) / count);
}

// The seed of this share's random scenes; that of the first share is `seed` itself.
std::uint64_t share_seed(std::uint64_t seed);

// Whether an item of an enumeration is in this share. Each item is in exactly one share. Items are
// dealt by a hash of their number, so that a share has some of every row of a grid.
bool is_in_share(std::uint64_t item);

}  // namespace edgecase
