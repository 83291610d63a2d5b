// SPDX-License-Identifier: MIT
//
// Values without rounding: equal to the literal formulas in fractions, and within the intervals.
#include "rules/values/rational_interpolation.h"

#include <gtest/gtest.h>

#include "tests/oracles/area_ratios.h"
#include "tests/rules/values/interpolants.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

// A random primitive and what it says at a sample, by the formulas of 14.5.1 and 14.6.1.
class RationalSource {
 public:
  explicit RationalSource(std::uint64_t seed) : numbers_(share_seed(seed)) {}

  Interpolant next() {
    Interpolant f;
    f.kind = static_cast<PrimitiveKind>(numbers_.integer(0, 2));
    f.perspective = numbers_.one_in(2);
    if (numbers_.one_in(2)) f.line_parameter = LineParameter::major_axis;
    const double bits = numbers_.one_in(4) ? 0 : numbers_.real(0, 10);
    for (std::size_t i = 0; i < 3; ++i) {
      f.positions[i] = numbers_.one_in(2) ? homogeneous(numbers_.point(kLimit)) : quotient();
      f.values[i] = numbers_.attribute(numbers_.one_in(2) ? 2 : 1e6);
      f.w[i] = numbers_.clip_w(bits);
    }
    return f;
  }
  Point sample() { return numbers_.point(kLimit); }
  PixelPosition pixel() {
    return {static_cast<int>(numbers_.integer(0, 20)), static_cast<int>(numbers_.integer(0, 20))};
  }

 private:
  static constexpr std::int64_t kLimit = 20 * Fixed::kOne;
  HomogeneousPoint quotient() {
    const std::int64_t w = numbers_.integer(1, std::int64_t{1} << numbers_.integer(1, 32));
    const std::int64_t x = numbers_.integer(-20 * w, 20 * w);
    return {x, numbers_.integer(-20 * w, 20 * w), w};
  }
  RandomNumbers numbers_;
};

// Vertices in fractions.
ProjectedTriangle<Rational> in_fractions(const Interpolant& f) {
  ProjectedTriangle<Rational> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const HomogeneousPoint& p = f.positions[i];
    result.x[i] = Rational(Integer(p.x), Integer(p.w));
    result.y[i] = Rational(Integer(p.y), Integer(p.w));
    result.w[i] = f.perspective ? rational_of(f.w[i].low) : Rational(1);
    result.values[i] = rational_of(f.values[i].low);
  }
  return result;
}

Rational literal_line(const Interpolant& f, const Rational& x, const Rational& y) {
  const auto v = in_fractions(f);
  const Rational run_x = v.x[1] - v.x[0], run_y = v.y[1] - v.y[0];
  Rational t = ((x - v.x[0]) * run_x + (y - v.y[0]) * run_y) / (run_x * run_x + run_y * run_y);
  if (f.line_parameter == LineParameter::major_axis)
    t = abs(run_x) >= abs(run_y) ? (x - v.x[0]) / run_x : (y - v.y[0]) / run_y;
  return ((1 - t) * v.values[0] / v.w[0] + t * v.values[1] / v.w[1]) /
         ((1 - t) / v.w[0] + t / v.w[1]);
}

Rational literal(const Interpolant& f, const Rational& x, const Rational& y) {
  if (f.kind == PrimitiveKind::point) return rational_of(f.values[0].low);
  if (f.kind == PrimitiveKind::line) return literal_line(f, x, y);
  return by_area_ratios(in_fractions(f), x, y);
}

Rational literal(const Interpolant& f, PixelPosition pixel) {
  return literal(f, pixel.x + Rational(1, 2), pixel.y + Rational(1, 2));
}

bool holds(Interval interval, const Rational& value) {
  return (std::isinf(interval.low) || rational_of(interval.low) <= value) &&
         (std::isinf(interval.high) || value <= rational_of(interval.high));
}

TEST(RationalInterpolation, ValuesAreThoseOfTheFormula) {
  RationalSource source(1);
  for (int i = 0; i < share_of(20'000); ++i) {
    const Interpolant f = source.next();
    const Point sample = source.sample();
    const auto value = interpolate_rational(f, sample);
    ASSERT_TRUE(value);
    ASSERT_EQ(*value, literal(f, Rational(sample.x.raw(), Fixed::kOne),
                              Rational(sample.y.raw(), Fixed::kOne)));
    ASSERT_TRUE(holds(interpolate_exact(f, sample), *value));
  }
}

TEST(RationalInterpolation, DerivativesAreDifferences) {
  RationalSource source(2);
  for (int i = 0; i < share_of(2'000, 250); ++i) {
    const Interpolant f = source.next();
    const QuadPixel at = in_quad(source.pixel(), RowOrder::bottom_up, 20);
    const auto [qx, qy] = at.quad;
    const auto difference = [&](int x, int y, Axis axis) -> Rational {
      const PixelPosition next =
          axis == Axis::x ? PixelPosition{x + 1, y} : PixelPosition{x, y + 1};
      return literal(f, next) - literal(f, {x, y});
    };
    for (const Axis axis : {Axis::x, Axis::y}) {
      const bool x = axis == Axis::x;
      const auto expect = [&](DerivativeMethod method, int column, int row) {
        const auto found = derivative_rational(f, at, axis, method);
        ASSERT_TRUE(found);
        ASSERT_EQ(*found, difference(column, row, axis)) << name_of(method);
        ASSERT_TRUE(holds(derivative_exact(f, at, axis, method), *found)) << name_of(method);
      };
      expect(DerivativeMethod::forward, at.pixel.x, at.pixel.y);
      expect(DerivativeMethod::fine, x ? qx : at.pixel.x, x ? at.pixel.y : qy);
      expect(DerivativeMethod::coarse_bottom_left, qx, qy);
      expect(DerivativeMethod::coarse_top_left, qx, x ? qy + 1 : qy);
      expect(DerivativeMethod::coarse_bottom_right, x ? qx : qx + 1, qy);
      expect(DerivativeMethod::coarse_top_right, x ? qx : qx + 1, x ? qy + 1 : qy);
      // Of an odd quad: the pixel before an even pixel, that of an odd one.
      const auto odd = [](int at_pixel) { return at_pixel % 2 == 0 ? at_pixel - 1 : at_pixel; };
      expect(DerivativeMethod::fine_odd, x ? odd(at.pixel.x) : at.pixel.x,
             x ? at.pixel.y : odd(at.pixel.y));
      expect(DerivativeMethod::other_row, x ? qx : 2 * qx + 1 - at.pixel.x,
             x ? 2 * qy + 1 - at.pixel.y : qy);
    }
  }
}

// The difference quotient over 2h is off by terms in h^2, which shrink fourfold as h is halved.
TEST(RationalInterpolation, TheAnalyticDerivativeIsWhatDifferencesTendTo) {
  RationalSource source(3);
  const Rational h = power_of_two(-60);
  for (int i = 0; i < share_of(2'000, 250); ++i) {
    const Interpolant f = source.next();
    const QuadPixel at = in_quad(source.pixel(), RowOrder::bottom_up, 20);
    const Rational x = at.pixel.x + Rational(1, 2), y = at.pixel.y + Rational(1, 2);
    for (const Axis axis : {Axis::x, Axis::y}) {
      const auto slope = derivative_rational(f, at, axis, DerivativeMethod::analytic);
      ASSERT_TRUE(slope);
      ASSERT_TRUE(holds(derivative_exact(f, at, axis, DerivativeMethod::analytic), *slope));
      const auto off = [&](const Rational& step) -> Rational {
        const Rational dx = axis == Axis::x ? step : Rational(0), dy = step - dx;
        return (literal(f, x + dx, y + dy) - literal(f, x - dx, y - dy)) / (2 * step) - *slope;
      };
      const Rational first = off(h), second = off(h / 2);
      if (first == 0) {
        ASSERT_EQ(second, 0);
      } else {
        ASSERT_LT(abs(first / second - 4), Rational(1, 1'000'000));
      }
    }
  }
}

TEST(RationalInterpolation, WithoutAnswers) {
  Interpolant f;
  f.positions = {vertex_at(0, 0), vertex_at(4, 4), vertex_at(8, 8)};
  f.values = {1, 2, 3};
  EXPECT_FALSE(interpolate_rational(f, at(1, 1)));
  f.positions[2] = vertex_at(8, 0);
  EXPECT_TRUE(interpolate_rational(f, at(1, 1)));
  f.values[1] = Interval(2, 2.5);
  EXPECT_FALSE(interpolate_rational(f, at(1, 1)));
  f.values[1] = Interval::everything();
  EXPECT_FALSE(interpolate_rational(f, at(1, 1)));
}

// 1/w is 0 at x = 8, to the right of which the plane is behind the eye.
TEST(RationalInterpolation, TheHorizonHasNoValue) {
  Interpolant f;
  f.kind = PrimitiveKind::line;
  f.positions = {vertex_at(0.5, 0.5), vertex_at(4.5, 0.5), vertex_at(0, 0)};
  f.values = {0, 1, 0};
  f.w = {1, 2, 1};
  EXPECT_EQ(interpolate_rational(f, at(4.5, 0.5)), Rational(1));
  EXPECT_FALSE(interpolate_rational(f, at(8.5, 0.5)));
  EXPECT_EQ(interpolate_rational(f, at(12.5, 0.5)), Rational(-3));
  const QuadPixel pixel{{7, 0}, {7, 0}};
  EXPECT_FALSE(derivative_rational(f, pixel, Axis::x, DerivativeMethod::forward));
  EXPECT_FALSE(derivative_rational(f, {{8, 0}, {8, 0}}, Axis::x, DerivativeMethod::analytic));
}

// Along an axis 1/w runs by whole numbers, also by one: only where it does not run at all are all
// methods one.
TEST(RationalInterpolation, DerivativesAreDifferencesHoweverSlowlyWRuns) {
  const QuadPixel pixel{{0, 0}, {0, 0}};
  for (const bool is_x : {true, false})
    for (const auto& w : {std::array<Interval, 3>{2, 1, 1}, {1, 2, 1}}) {
      Interpolant f;
      f.kind = PrimitiveKind::line;
      f.positions = {vertex_at(0.5, 0.5), is_x ? vertex_at(2.5, 0.5) : vertex_at(0.5, 2.5),
                     vertex_at(0, 0)};
      f.values = {0, 1, 0};
      f.w = w;
      const PixelPosition next = is_x ? PixelPosition{1, 0} : PixelPosition{0, 1};
      EXPECT_EQ(derivative_rational(f, pixel, is_x ? Axis::x : Axis::y, DerivativeMethod::forward),
                Rational(literal(f, next) - literal(f, PixelPosition{0, 0})));
    }
}

TEST(RationalInterpolation, ConstantsNeedNoExtent) {
  Interpolant f;
  f.values = {0.1, 0.1, 0.1};
  EXPECT_EQ(interpolate_rational(f, at(3, 3)), rational_of(0.1));
  EXPECT_EQ(derivative_rational(f, {}, Axis::x, DerivativeMethod::analytic), Rational(0));
}

}  // namespace
}  // namespace edgecase
