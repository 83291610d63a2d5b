// SPDX-License-Identifier: MIT
//
// How a picture differs from another one: nearly all zero where they are nearly alike, and so
// nearly free to store.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgecase {

// Byte by byte exclusive or of two pictures of the same size. Of one picture and its difference
// from another, the other one.
inline std::vector<std::uint8_t> difference_of(const std::vector<std::uint8_t>& a,
                                               const std::vector<std::uint8_t>& b) {
  std::vector<std::uint8_t> out(std::min(a.size(), b.size()));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] ^ b[i];
  return out;
}

}  // namespace edgecase
