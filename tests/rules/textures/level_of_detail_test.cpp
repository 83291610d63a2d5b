// SPDX-License-Identifier: MIT
//
// Scale factors: every footprint whose four partials are multiples of 1/2 from -4 to 4, against
// their squares in whole numbers; then biases and clamps.
#include "rules/textures/level_of_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "rules/values/derivative.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Partials in halves of a texel: du/dx, dv/dx, du/dy, dv/dy.
using Halves = std::array<int, 4>;

Footprint footprint_of(const Halves& h) {
  return {{h[0] / 2.0, h[1] / 2.0}, {h[2] / 2.0, h[3] / 2.0}, 2};
}

template <class Visit>
void for_each_footprint(Visit visit) {
  for (int a = -8; a <= 8; ++a)
    for (int b = -8; b <= 8; ++b)
      for (int c = -8; c <= 8; ++c)
        for (int d = -8; d <= 8; ++d) visit(Halves{a, b, c, d});
}

int largest_of(int a, int b) {
  return std::max(std::abs(a), std::abs(b));
}

// The square of the scale factor, in quarters.
int literal_square(const Halves& h, ScaleFactor method) {
  const auto [ux, vx, uy, vy] = h;
  const auto square = [](int value) { return value * value; };
  const int along_x = square(ux) + square(vx);
  const int along_y = square(uy) + square(vy);
  switch (method) {
    case ScaleFactor::lengths:
      return std::max(along_x, along_y);
    case ScaleFactor::largest_partial:
      return square(std::max(largest_of(ux, uy), largest_of(vx, vy)));
    case ScaleFactor::sum_of_partials:
      return square(largest_of(ux, uy) + largest_of(vx, vy));
    case ScaleFactor::length_of_sum:
      return square(ux + uy) + square(vx + vy);
    case ScaleFactor::length_of_both:
      return along_x + along_y;
    case ScaleFactor::sum:
      return square(std::abs(ux) + std::abs(vx) + std::abs(uy) + std::abs(vy));
    case ScaleFactor::x_only:
      return along_x;
    case ScaleFactor::y_only:
      return along_y;
  }
  return 0;
}

bool is_square(int value) {
  const int root = static_cast<int>(std::lround(std::sqrt(value)));
  return root * root == value;
}

Wide squared(double value) {
  return static_cast<Wide>(value) * static_cast<Wide>(value);
}

TEST(ScaleFactors, AreTheNarrowestIntervalsAroundTheFormulas) {
  for_each_footprint([](const Halves& h) {
    for (const ScaleFactor method : values_of<ScaleFactor>()) {
      const Interval result = scale_factor(footprint_of(h), method);
      const int quarters = literal_square(h, method);
      const Wide expected = static_cast<Wide>(quarters) / 4;
      ASSERT_LE(squared(result.low), expected);
      ASSERT_GE(squared(result.high), expected);
      ASSERT_EQ(result.high, is_square(quarters) ? result.low : next_above(result.low));
    }
  });
}

// Either upper bound of the section is the larger one somewhere.
TEST(ScaleFactors, PermittedIsFromTheLargestPartialToTheLargerBound) {
  int by_sum = 0, by_root = 0;
  for_each_footprint([&](const Halves& h) {
    const Interval permitted = permitted_scale_factor(footprint_of(h));
    const int m_u = largest_of(h[0], h[2]);
    const int m_v = largest_of(h[1], h[3]);
    ASSERT_EQ(permitted.low, std::max(m_u, m_v) / 2.0);
    const int sum = m_u + m_v;
    const int larger = std::max(std::abs(h[0]) + std::abs(h[1]), std::abs(h[2]) + std::abs(h[3]));
    if (2 * larger * larger <= sum * sum) {
      ASSERT_EQ(permitted.high, sum / 2.0);
      ++by_sum;
    } else {
      ASSERT_GE(permitted.high * permitted.high, larger * larger / 2.0);
      ASSERT_LE(permitted.high, std::sqrt(2.0) * larger / 2 * (1 + 1e-15));
      ++by_root;
    }
  });
  EXPECT_GT(by_sum, 0);
  EXPECT_GT(by_root, 0);
}

// OpenGL ES has the second bound alone, which need not hold m_u + m_v.
TEST(ScaleFactors, PermittedOfOpenGlEsIsWithinTheSecondBound) {
  int smaller = 0;
  for_each_footprint([&](const Halves& h) {
    const Interval both = permitted_scale_factor(footprint_of(h));
    const Interval es = permitted_scale_factor(footprint_of(h), {kLeastBiasLimit, true});
    const int larger = std::max(std::abs(h[0]) + std::abs(h[1]), std::abs(h[2]) + std::abs(h[3]));
    ASSERT_EQ(es.low, both.low);
    ASSERT_GE(es.high * es.high, larger * larger / 2.0);
    ASSERT_LE(es.high, std::sqrt(2.0) * larger / 2 * (1 + 1e-15));
    if (es.high < both.high) ++smaller;
  });
  EXPECT_GT(smaller, 0);
}

// The ellipse's major axis, the larger singular value of the derivatives, is what the scale factor
// should ideally be.
TEST(ScaleFactors, PermittedHoldsTheMajorAxis) {
  for_each_footprint([](const Halves& h) {
    const double a = h[0] / 2.0, b = h[1] / 2.0, c = h[2] / 2.0, d = h[3] / 2.0;
    const double squares = a * a + b * b + c * c + d * d;
    const double area = a * d - b * c;
    const double root = std::sqrt(std::max(squares * squares - 4 * area * area, 0.0));
    const double axis = std::sqrt((squares + root) / 2);
    const Interval permitted = permitted_scale_factor(footprint_of(h));
    ASSERT_GE(axis, permitted.low * (1 - 1e-12));
    ASSERT_LE(axis, permitted.high * (1 + 1e-12));
  });
}

bool conforms(ScaleFactor method) {
  for (const Alternative& alternative : scale_factor_rule().alternatives)
    if (alternative.name == name_of(method)) return alternative.openness != Openness::illegal;
  return false;
}

// The square of the larger upper bound, in quarters.
int literal_bound(const Halves& h) {
  const int larger = std::max(std::abs(h[0]) + std::abs(h[1]), std::abs(h[2]) + std::abs(h[3]));
  return std::max(literal_square(h, ScaleFactor::sum_of_partials), 2 * larger * larger);
}

// The two conditions of 8.14.1, over the whole grid: an alternative is open where it keeps both,
// illegal where it breaks one.
TEST(ScaleFactors, AreOpenWhereTheyKeepTheConditions) {
  for (const ScaleFactor method : values_of<ScaleFactor>()) {
    bool within = true;
    bool monotonic = true;
    for_each_footprint([&](const Halves& h) {
      const int square = literal_square(h, method);
      within = within && literal_square(h, ScaleFactor::largest_partial) <= square &&
               square <= literal_bound(h);
      for (std::size_t i = 0; i < 4; ++i) {
        Halves more = h;
        more[i] += h[i] < 0 ? -1 : 1;
        monotonic = monotonic && literal_square(more, method) >= square;
      }
    });
    EXPECT_EQ(within && monotonic, conforms(method)) << name_of(method);
    EXPECT_EQ(monotonic, method != ScaleFactor::length_of_sum) << name_of(method);
  }
}

TEST(ScaleFactors, OneFootprintTellsAllApart) {
  std::set<double> results;
  for (const ScaleFactor method : values_of<ScaleFactor>())
    results.insert(scale_factor(footprint_of({5, 2, 1, 4}), method).low);
  // Here the vector along x is the longer one; where it is not, y-only is.
  EXPECT_EQ(results.size(), values_of<ScaleFactor>().size() - 1);
  EXPECT_EQ(scale_factor(footprint_of({5, 2, 1, 4}), ScaleFactor::x_only).low,
            scale_factor(footprint_of({5, 2, 1, 4}), ScaleFactor::lengths).low);
  EXPECT_LT(scale_factor(footprint_of({1, 4, 5, 2}), ScaleFactor::x_only).high,
            scale_factor(footprint_of({1, 4, 5, 2}), ScaleFactor::lengths).low);
}

double drawn_in(RandomNumbers& random, Interval interval) {
  switch (random.integer(0, 3)) {
    case 0:
      return interval.low;
    case 1:
      return interval.high;
    default:
      return random.real(interval.low, interval.high);
  }
}

Interval drawn_interval(RandomNumbers& random) {
  const double a = random.attribute(20);
  const double b = random.one_in(3) ? a : random.attribute(20);
  return {std::min(a, b), std::max(a, b)};
}

TEST(ScaleFactors, OfIntervalsHoldThoseOfTheirPoints) {
  RandomNumbers random(3);
  for (int i = 0; i < 20'000; ++i) {
    const Footprint box = {{drawn_interval(random), drawn_interval(random)},
                           {drawn_interval(random), drawn_interval(random)},
                           random.one_in(3) ? 1 : 2};
    const Interval permitted = permitted_scale_factor(box);
    for (int k = 0; k < 4; ++k) {
      const Footprint point = {{drawn_in(random, box.dx[0]), drawn_in(random, box.dx[1])},
                               {drawn_in(random, box.dy[0]), drawn_in(random, box.dy[1])},
                               box.dimensions};
      for (const ScaleFactor method : values_of<ScaleFactor>()) {
        const Interval result = scale_factor(point, method);
        ASSERT_TRUE(holds(scale_factor(box, method), result)) << name_of(method);
        if (!conforms(method)) continue;
        ASSERT_LE(result.low, permitted.high) << name_of(method);
        ASSERT_GE(result.high, permitted.low) << name_of(method);
      }
    }
  }
}

// Both ends are reached: at the corner of least absolute values, and at that of the largest.
TEST(ScaleFactors, OfIntervalsReachTheirEnds) {
  const Footprint box = {{Interval(-3, 1), Interval(2, 4)}, {Interval(-5, -1), Interval(0, 2)}, 2};
  const Footprint least = {{0, 2}, {1, 0}, 2};
  const Footprint most = {{3, 4}, {5, 2}, 2};
  for (const ScaleFactor method : values_of<ScaleFactor>()) {
    if (method == ScaleFactor::length_of_sum) continue;
    EXPECT_EQ(scale_factor(box, method).low, scale_factor(least, method).low) << name_of(method);
    EXPECT_EQ(scale_factor(box, method).high, scale_factor(most, method).high) << name_of(method);
  }
  // du = -8 to 0, dv = 2 to 6.
  EXPECT_EQ(scale_factor(box, ScaleFactor::length_of_sum).low, 2);
  EXPECT_EQ(scale_factor(box, ScaleFactor::length_of_sum).high, 10);
}

TEST(ScaleFactors, InOneDimensionAreTheLargerPartial) {
  const Footprint line = {{-3, 100}, {2, kNone}, 1};
  for (const ScaleFactor method :
       {ScaleFactor::lengths, ScaleFactor::largest_partial, ScaleFactor::sum_of_partials}) {
    EXPECT_EQ(scale_factor(line, method).low, 3) << name_of(method);
    EXPECT_EQ(scale_factor(line, method).high, 3) << name_of(method);
  }
  EXPECT_EQ(permitted_scale_factor(line).low, 3);
  EXPECT_NEAR(permitted_scale_factor(line).high, 3 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(scale_factor(line, ScaleFactor::length_of_sum).high, 1);
  EXPECT_EQ(scale_factor(line, ScaleFactor::sum).high, 5);
}

TEST(ScaleFactors, AreDefinedForEverything) {
  for (const ScaleFactor method : values_of<ScaleFactor>()) {
    const Interval unknown = scale_factor({{kNone, kNone}, {kNone, kNone}, 2}, method);
    EXPECT_EQ(unknown.low, 0) << name_of(method);
    EXPECT_EQ(unknown.high, kInfinity) << name_of(method);
    const Interval endless =
        scale_factor({{kInfinity, kInfinity}, {kInfinity, kInfinity}, 2}, method);
    EXPECT_EQ(endless.low, kInfinity) << name_of(method);
    EXPECT_EQ(endless.high, kInfinity) << name_of(method);
    EXPECT_EQ(scale_factor({}, method).high, 0) << name_of(method);
  }
  const Interval opposite =
      scale_factor({{kInfinity, 0}, {-kInfinity, 0}, 2}, ScaleFactor::length_of_sum);
  EXPECT_EQ(opposite.low, 0);
  EXPECT_EQ(opposite.high, kInfinity);
}

TEST(Footprints, AreInTexelsOfTheBaseLevel) {
  const Footprint f = footprint({0.25, -0.5}, {Interval(0, 1), kNone}, 64, 16, 2);
  EXPECT_EQ(f.dx[0].low, 16);
  EXPECT_EQ(f.dx[1].low, -8);
  EXPECT_EQ(f.dy[0].low, 0);
  EXPECT_EQ(f.dy[0].high, 64);
  EXPECT_TRUE(is_everything(f.dy[1]));
  const Footprint line = footprint({0.25, 7}, {1, kNone}, 64, 1, 1);
  EXPECT_EQ(line.dx[1].high, 0);
  EXPECT_EQ(line.dy[1].high, 0);
}

TEST(Footprints, HaveTwoDimensionsUnlessTheySayOne) {
  const Footprint f{{3, 4}, {}};
  EXPECT_EQ(f.dimensions, 2);
  EXPECT_EQ(scale_factor(f, ScaleFactor::lengths).high, 5);
}

// A footprint of 2^k texels along an axis has the level k and nothing beside it.
TEST(Footprints, OfPowersOfTwoHaveWholeLevels) {
  for (int k = -10; k <= 10; ++k) {
    const double side = std::ldexp(1.0 / 256, k);
    for (const Footprint& f : {footprint({side, 0}, {0, side}, 256, 256, 2),
                               footprint({0, -side}, {side / 2, 0}, 256, 256, 2)}) {
      const Interval level = log2_of(scale_factor(f, ScaleFactor::lengths), Log2Method::exact);
      EXPECT_EQ(level.low, k);
      EXPECT_EQ(level.high, k);
    }
  }
}

TEST(LevelOfDetailRules, DerivativesAreThoseOfPlainOnes) {
  EXPECT_EQ(level_derivatives_rule().alternatives.size(), values_of<DerivativeMethod>().size());
  EXPECT_EQ(level_derivatives_rule().standard, derivative_rule().standard);
  EXPECT_TRUE(level_derivatives_rule().rulings.empty());
}

}  // namespace
}  // namespace edgecase
