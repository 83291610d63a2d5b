// SPDX-License-Identifier: MIT
#include "casefile/shading_patterns.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "casefile/split_mix.h"
#include "exact/elementary.h"

namespace edgecase {
namespace {

constexpr std::int64_t kUnitWeight = std::int64_t{1} << 16;

// 0 to count - 1, at most 2^16 numbers.
std::int64_t below(std::int64_t count, std::uint64_t& state) {
  const std::uint64_t word = next_word(state) >> 32;
  return static_cast<std::int64_t>((word * static_cast<std::uint64_t>(count)) >> 32);
}

// The first multiple of 2^-16, raw, that is not below i / n.
std::int64_t start_of_cell(std::int64_t i, int n) {
  return (i * Fixed::kOne + n - 1) / n;
}

Fixed within_cell(int i, int n, std::uint64_t& state) {
  const std::int64_t start = start_of_cell(i, n);
  return Fixed::from_raw(start + below(start_of_cell(i + 1, n) - start, state));
}

Point point_of_cell(int column, int row, int n, std::uint64_t& state) {
  const Fixed x = within_cell(column, n, state);
  return {x, within_cell(row, n, state)};
}

// numerator / denominator, neither of them negative, to the nearest whole number, a tie to even.
std::int64_t rounded_quotient(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t floor = numerator / denominator;
  const std::int64_t twice = 2 * (numerator % denominator);
  return twice > denominator || (twice == denominator && floor % 2 == 1) ? floor + 1 : floor;
}

std::int64_t weight_of(Point at, const ReconstructionFilter& filter) {
  const std::int64_t x = std::abs((at.x - Fixed::centre_of(0)).raw());
  const std::int64_t y = std::abs((at.y - Fixed::centre_of(0)).raw());
  const std::int64_t r = filter.radius.raw();
  if (x > r || y > r) return 0;
  switch (filter.kernel) {
    case Kernel::box:
      return 1;
    case Kernel::tent:  // at most 2^17 2^17 2^16
      return rounded_quotient((r - x) * (r - y) * kUnitWeight, r * r);
    case Kernel::gaussian:
      return std::llrint(
          exponential(-2 * static_cast<double>(x * x + y * y) / static_cast<double>(r * r)) *
          static_cast<double>(kUnitWeight));
  }
  return 0;
}

}  // namespace

Pattern grid_pattern(int n) {
  const auto centre = [&](int i) {
    return Fixed::from_raw(rounded_quotient((2 * i + 1) * Fixed::kOne, 2 * n));
  };
  Pattern pattern;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) pattern.push_back({centre(column), centre(row)});
  return pattern;
}

Pattern jittered_pattern(int n, std::uint64_t seed) {
  Pattern pattern;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column)
      pattern.push_back(point_of_cell(column, row, n, seed));
  return pattern;
}

Pattern n_rooks_pattern(int n, std::uint64_t seed) {
  std::vector<int> rows(static_cast<std::size_t>(n));
  std::iota(rows.begin(), rows.end(), 0);
  for (std::size_t left = rows.size(); left > 1; --left) {
    const std::int64_t chosen = below(static_cast<std::int64_t>(left), seed);
    std::swap(rows[left - 1], rows[static_cast<std::size_t>(chosen)]);
  }
  Pattern pattern;
  for (int column = 0; column < n; ++column)
    pattern.push_back(point_of_cell(column, rows[static_cast<std::size_t>(column)], n, seed));
  return pattern;
}

Pattern random_pattern(int n, std::uint64_t seed) {
  Pattern pattern;
  for (int i = 0; i < n; ++i) pattern.push_back(point_of_cell(0, 0, 1, seed));
  return pattern;
}

Supersampling filtered(const Pattern& pattern, const ReconstructionFilter& filter) {
  const int reach = filter.radius > Fixed::from_raw(Fixed::kOne / 2) ? 1 : 0;
  Supersampling passes;
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column)
      for (const Point within : pattern) {
        const Point at{within.x + Fixed::from_integer(column), within.y + Fixed::from_integer(row)};
        const std::int64_t weight = weight_of(at, filter);
        if (weight > 0) passes.push_back({at, weight});
      }
  return passes;
}

}  // namespace edgecase
