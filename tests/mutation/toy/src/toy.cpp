// SPDX-License-Identifier: MIT
#include "toy.h"

namespace toy {
namespace {

enum class Kind { even = 4, odd = 9 };

constexpr int kFirst = 3;
constexpr int kLength = 6;

}  // namespace

Limits::Limits() noexcept = default;

// At the limit both branches give the same: moving the boundary changes nothing.
int clamped_sum(int a, int b) {
  const int sum = a + b;
  return sum > Limits::kHigh ? Limits::kHigh : sum;
}

// Without the step down it never ends.
int count_down(int n) {
  int steps = 0;
  while (n > 0) {
    --n;
    steps += 2;
  }
  return steps;
}

int never_called(int n) {
  return n * 7;
}

int every_operator(int n, bool flag) {
  int table[4] = {5, 6, 7, 8};
  int result = kFirst;
  for (int i = 0; i < 4; ++i) {
    if (i == 2) continue;
    if (flag || i != 1) result += table[i];
    result -= std::min(i, 2);
  }
  switch (n % 2 == 0 ? Kind::even : Kind::odd) {
    case Kind::even:
      result = -result;
      break;
    case Kind::odd:
      result = ~result / 2;
      break;
  }
  if (!flag && n <= 7) result = (result << 1) | (n & 6);
  const auto twice = [](int value) { return value - -value; };
  return twice(result);
}

// The compiler needs the lengths; the values are for the program.
std::array<int, 2 + 1> multiples(int n) {
  std::array<int, kLength / 2> result{};
  for (int i = 0; i < 3; ++i) result[i] = n * i;
  return result;
}

// What the compiler decides cannot be a mutant's.
template <int... kNumbers>
int product_of() {
  if constexpr (sizeof...(kNumbers) == 0)
    return 1;
  else
    return (kNumbers * ...);
}

int product() {
  return product_of<2, 3>() + product_of<>();
}

std::string greeting(const std::string& name) {
  return "hello " + name;
}

}  // namespace toy
