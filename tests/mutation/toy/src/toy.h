// SPDX-License-Identifier: MIT
//
// Functions whose mutants have a known fate.
#pragma once

#include <algorithm>
#include <array>
#include <string>

namespace toy {

// Used in constant expressions and at run time.
constexpr int doubled(int n) {
  return n + n;
}
static_assert(doubled(2) == 4);

struct Limits {
  Limits() noexcept;
  int low = -1;
  static constexpr int kHigh = 100;

  friend bool operator==(const Limits&, const Limits&) = default;
};

int clamped_sum(int a, int b);
int count_down(int n);
int never_called(int n);
int every_operator(int n, bool flag);
std::array<int, 2 + 1> multiples(int n);
int product();  // 7
std::string greeting(const std::string& name);

}  // namespace toy
