// SPDX-License-Identifier: MIT
//
// 128-bit integers, for the few exact decisions whose products leave 64 bits.
#pragma once

namespace edgecase {

__extension__ using Int128 = __int128;

constexpr int sign(Int128 value) {
  return (value > 0) - (value < 0);
}

}  // namespace edgecase
