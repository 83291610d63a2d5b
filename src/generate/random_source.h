// SPDX-License-Identifier: MIT
//
// RandomSource: the numbers of random scenes. They depend only on the arguments of its constructor;
// the standard library's distributions differ between machines.
//
// The generator is splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number
// generators", 2014): a counter and a mixing of its bits.
#pragma once

#include <cstdint>
#include <span>

namespace edgecase {

class RandomSource {
 public:
  // `stream` separates generators of one seed.
  RandomSource(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
      : state_(mixed(mixed(mixed(seed) + stream) + index)) {}

  std::uint64_t next() { return mixed(state_ += kStep); }

  // From 0 to count - 1; count is 1 to 2^40. The bias of the remainder is at most 2^-24.
  std::int64_t below(std::int64_t count) {
    return static_cast<std::int64_t>(next() % static_cast<std::uint64_t>(count));
  }
  // Both ends inclusive.
  std::int64_t between(std::int64_t low, std::int64_t high) { return low + below(high - low + 1); }
  // True with probability 1 / many.
  bool one_in(int many) { return below(many) == 0; }
  std::int64_t sign() { return one_in(2) ? 1 : -1; }
  // From 1 to 2^octaves: octaves are equally likely, and values uniform within one.
  std::int64_t log_uniform(int octaves) {
    const std::int64_t low = std::int64_t{1} << below(octaves);
    return between(low, 2 * low);
  }
  template <class T>
  const T& one_of(std::span<const T> values) {
    return values[static_cast<std::size_t>(below(static_cast<std::int64_t>(values.size())))];
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;
  static constexpr std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace edgecase
