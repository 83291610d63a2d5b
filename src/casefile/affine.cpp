// SPDX-License-Identifier: MIT
#include "casefile/affine.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "exact/elementary.h"
#include "exact/fixed.h"

namespace edgecase {
namespace {

constexpr int kFineBits = 48;  // fraction bits of steps and points
constexpr int kSpareBits = kFineBits - Fixed::kFractionBits;
constexpr std::int64_t kMostFine = std::int64_t{1} << (14 + kFineBits);  // 2^14 pixels
// A factor has 2^58 units at most and a coordinate 2^62: the sum of two products fits in 122 bits.
static_assert(kMaxAffineFactor == 1 << 10 && kMaxAffineShift == 1 << 14);

std::int64_t fine(Fixed value) {
  return value.raw() * (std::int64_t{1} << kSpareBits);
}

// numerator / 2^bits to the nearest, ties up; clears `exact` where that is not the number itself.
Int128 shifted(Int128 numerator, int bits, bool& exact) {
  const Int128 unit = Int128{1} << bits;
  const Int128 quotient = (numerator + unit / 2) >> bits;
  exact = exact && quotient * unit == numerator;
  return quotient;
}

bool in_range(Int128 value) {
  return value >= -kMostFine && value <= kMostFine;
}

}  // namespace

AffineStep affine_step(const std::array<Fixed, 6>& a_to_f) {
  AffineStep step;
  for (std::size_t i = 0; i < 4; ++i) step.linear[i] = fine(a_to_f[i]);
  for (std::size_t i = 0; i < 2; ++i) step.shift[i] = fine(a_to_f[4 + i]);
  return step;
}

AffineStep turn_step(Fixed degrees) {
  constexpr std::int64_t kQuarter = 90 * Fixed::kOne;
  const std::int64_t turn = ((degrees.raw() % (4 * kQuarter)) + 4 * kQuarter) % (4 * kQuarter);
  constexpr std::int64_t kUnit = std::int64_t{1} << kFineBits;
  if (turn % kQuarter == 0) {
    constexpr std::int64_t kCosines[] = {kUnit, 0, -kUnit, 0};
    const auto quarters = static_cast<std::size_t>(turn / kQuarter);
    const std::int64_t c = kCosines[quarters];
    const std::int64_t s = kCosines[(quarters + 3) % 4];
    return {{c, s, -s, c}, {}, true};
  }
  const double angle = Fixed::from_raw(turn).to_double() * std::numbers::pi / 180;
  const std::int64_t c = std::llround(std::ldexp(cosine(angle), kFineBits));
  const std::int64_t s = std::llround(std::ldexp(sine(angle), kFineBits));
  return {{c, s, -s, c}, {}, false};
}

std::optional<MovedPoint> move_point(Point point, std::span<const AffineStep> steps) {
  Int128 x = fine(point.x);
  Int128 y = fine(point.y);
  bool exact = true;
  for (const AffineStep& step : steps) {
    exact = exact && step.exact;
    const auto& [a, b, c, d] = step.linear;
    const Int128 next_x = shifted(a * x + c * y, kFineBits, exact) + step.shift[0];
    const Int128 next_y = shifted(b * x + d * y, kFineBits, exact) + step.shift[1];
    if (!in_range(next_x) || !in_range(next_y)) return std::nullopt;
    x = next_x;
    y = next_y;
  }
  const Int128 raw_x = shifted(x, kSpareBits, exact);
  const Int128 raw_y = shifted(y, kSpareBits, exact);
  return MovedPoint{{Fixed::from_raw(static_cast<std::int64_t>(raw_x)),
                     Fixed::from_raw(static_cast<std::int64_t>(raw_y))},
                    exact};
}

}  // namespace edgecase
