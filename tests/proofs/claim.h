// SPDX-License-Identifier: MIT
//
// What a claim is written with. A claim is a function without arguments, `claim_NAME`; the prover
// (prove.py) follows every path of it at once and shows, for all numbers that `between` may return,
// that every `check` holds, that no signed integer overflows, no shift leaves its width, nothing is
// divided by zero, and no number is cut off by a conversion. Nothing here is ever run.
#pragma once

#include <cstdint>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "rules/coverage/tie_rule.h"

extern "C" {
// Any number from `low` to `high`, both included; constants.
std::int64_t between(std::int64_t low, std::int64_t high);
// What is claimed. Later checks may rely on it.
void check(bool holds);
// What is presupposed of the numbers.
void assume(bool holds);
}

namespace edgecase {

// A window coordinate, as fixed.h bounds them.
inline Fixed any_coordinate() {
  constexpr std::int64_t kMost = Fixed::kMaxCoordinate * Fixed::kOne;
  return Fixed::from_raw(between(-kMost, kMost));
}

inline Point any_point() {
  const Fixed x = any_coordinate();
  return {x, any_coordinate()};
}

// A column or row of a pixel of the window.
inline int any_pixel() {
  return static_cast<int>(between(-Fixed::kMaxCoordinate, Fixed::kMaxCoordinate - 1));
}

// A point as homogeneous.h bounds those with positive w, which is at most 2^`w_bits`.
inline HomogeneousPoint any_homogeneous(int w_bits) {
  const std::int64_t w = between(1, std::int64_t{1} << w_bits);
  const std::int64_t most = std::int64_t{1} << (w_bits + 14);
  const std::int64_t x = between(-most, most);
  const std::int64_t y = between(-most, most);
  assume(x <= w * (std::int64_t{1} << 14) && -x <= w * (std::int64_t{1} << 14));
  assume(y <= w * (std::int64_t{1} << 14) && -y <= w * (std::int64_t{1} << 14));
  return {x, y, w};
}

// Any tie rule: one of each kind, with any move, those of the ten rules among them.
inline TieRule any_ties() {
  TieRule ties;
  const std::int64_t kind = between(0, 2);
  ties.kind = kind == 0   ? TieRule::Kind::perturbed
              : kind == 1 ? TieRule::Kind::open
                          : TieRule::Kind::closed;
  ties.first_x = static_cast<int>(between(-1, 1));
  ties.first_y = static_cast<int>(between(-1, 1));
  ties.second_x = static_cast<int>(between(-1, 1));
  ties.second_y = static_cast<int>(between(-1, 1));
  return ties;
}

// Any of the eight perturbed rules: one axis dominates, the other decides what it leaves open.
inline TieRule any_perturbed_ties() {
  TieRule ties;
  const int first = between(0, 1) == 0 ? -1 : 1;
  const int second = between(0, 1) == 0 ? -1 : 1;
  const bool x_dominates = between(0, 1) == 0;
  ties.first_x = x_dominates ? first : 0;
  ties.first_y = x_dominates ? 0 : first;
  ties.second_x = x_dominates ? 0 : second;
  ties.second_y = x_dominates ? second : 0;
  return ties;
}

}  // namespace edgecase
