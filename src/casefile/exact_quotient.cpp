// SPDX-License-Identifier: MIT
//
// The exact sum is kept as doubles that do not overlap (J. R. Shewchuk, Adaptive Precision
// Floating-Point Arithmetic, 1997): adding two doubles leaves an error that is a double itself, and
// so is what a division leaves over. A quotient that is not exact is then taken towards zero and
// its last bit set ("round to odd"), so that the second rounding, to float32, errs no more than one
// rounding of the true quotient would: a double has more than two bits to spare.
#include "casefile/exact_quotient.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace edgecase {
namespace {

// Doubles that do not overlap, from the least to the largest magnitude; zeros are left out.
struct Expansion {
  std::array<double, 10> parts{};  // as many as terms: 8, and the two of a product
  std::size_t size = 0;
};

void add(double term, Expansion& sum) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sum.size; ++i) {
    double larger = term;
    double smaller = sum.parts[i];
    if (std::fabs(larger) < std::fabs(smaller)) std::swap(larger, smaller);
    term = larger + smaller;
    const double error = smaller - (term - larger);
    if (error != 0) sum.parts[kept++] = error;
  }
  if (term != 0) sum.parts[kept++] = term;
  sum.size = kept;
}

double nearest(const Expansion& sum) {
  double value = 0;
  for (std::size_t i = 0; i < sum.size; ++i) value += sum.parts[i];
  return value;
}

// sum - quotient * divisor.
Expansion left_over(Expansion sum, double quotient, double divisor) {
  const double product = quotient * divisor;
  add(-product, sum);
  add(-std::fma(quotient, divisor, -product), sum);
  return sum;
}

// Of a quotient next to the true one: `lacks` has the sign of what it lacks.
double round_to_odd(double quotient, double lacks) {
  if (lacks == 0) return quotient;
  if ((lacks < 0) != (quotient < 0)) quotient = std::nextafter(quotient, 0.0);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(quotient) | 1U);
}

}  // namespace

float nearest_quotient(std::span<const double> terms, double divisor) {
  Expansion sum;
  for (const double term : terms) add(term, sum);
  // The first quotient may be two doubles away, the corrected one is next to the true one.
  double quotient = nearest(sum) / divisor;
  quotient += nearest(left_over(sum, quotient, divisor)) / divisor;
  const double lacks = nearest(left_over(sum, quotient, divisor));
  return static_cast<float>(round_to_odd(quotient, lacks)) + 0.0F;
}

}  // namespace edgecase
