// SPDX-License-Identifier: MIT
//
// SplitMix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014): what case
// files leave to a seed is the same on every machine.
#pragma once

#include <cstdint>

namespace edgecase {

// 64 random bits; `state` starts as the seed.
inline std::uint64_t next_word(std::uint64_t& state) {
  state += 0x9E3779B97F4A7C15U;
  std::uint64_t word = state;
  word = (word ^ (word >> 30)) * 0xBF58476D1CE4E5B9U;
  word = (word ^ (word >> 27)) * 0x94D049BB133111EBU;
  return word ^ (word >> 31);
}

}  // namespace edgecase
