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

// How many of `all` random scenes are in this share: the shares together have at least `all`, and
// each has `least`, where there are so many.
template <std::integral T>
T share_of(T all, T least = 1) {
  const auto count = static_cast<std::uint64_t>(all);
  const std::uint64_t part = count / share().count + (count % share().count != 0 ? 1 : 0);
  return std::min(all, std::max(least, static_cast<T>(part)));
}

// How often something has to be seen in this share that is seen `all` times in all of them: half of
// its part, for in few scenes chance does more.
template <std::integral T>
T least_of(T all) {
  return share().count == 1 ? all
                            : static_cast<T>(static_cast<std::uint64_t>(all) / share().count / 2);
}

// The seed of this share's random scenes; that of the first share is `seed` itself.
std::uint64_t share_seed(std::uint64_t seed);

// Whether an item of an enumeration is in this share. Each item is in exactly one share. Items are
// dealt by a hash of their number, so that a share has some of every row of a grid.
bool is_in_share(std::uint64_t item);

// Whether an item of a few is in this share: each of them is in one, or several, and each share has
// at least one of them.
inline bool is_in_share_of_few(std::uint64_t item, std::uint64_t items) {
  const std::uint64_t count = std::min(share().count, items);
  return item % count == share().number % count;
}

// Deals the items of an enumeration in the order in which they come, which has to be the same each
// time: `if (!dealer.deal()) continue;` in the innermost loop whose body takes its time.
class Dealer {
 public:
  // Whether the next item is in this share.
  bool deal() { return is_in_share(items_++); }
  // How many there were, in this share or not.
  long items() const { return static_cast<long>(items_); }

 private:
  std::uint64_t items_ = 0;
};

// How many times as many scenes tests of kernels ask: EDGECASE_KERNEL_SCENES, or 1.
int kernel_scene_factor();

// How many of that many times `count` random scenes are in this share.
int kernel_scenes(int count);

}  // namespace edgecase
