// SPDX-License-Identifier: MIT
//
// The latitude of interpolation holds what float32 arithmetic yields, whichever form of the formula
// it follows, from vertices that stay or move; and it is not much wider than that.
//
// The forms count from the first vertex, so that their condition is the triangle's own. Counted
// from the window's origin their terms grow with the square of the distance: planes stay within
// what a move of 2^-8 permits in targets of 64 pixels, the inverse of the matrix does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/oracles/area_ratios.h"
#include "tests/oracles/attribute_planes.h"
#include "tests/oracles/inverse_matrix.h"
#include "tests/rules/values/interpolants.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr int kScenes = 4000;
constexpr double kReach = 1.0 / 256;

enum class Shape { ample, small, sliver };
constexpr Shape kShapes[] = {Shape::ample, Shape::small, Shape::sliver};

struct Example {
  Interpolant f;
  double x = 0, y = 0;  // a pixel's centre, inside or nearly so
  Point sample() const { return at(x, y); }
};

class Latitude : public ::testing::Test {
 protected:
  // In a target of 64 pixels, coordinates multiples of 2^-8, so that float32 holds them; w ratios
  // up to 2^`bits`.
  Example example(Shape shape, double bits) {
    Example result;
    Interpolant& f = result.f;
    do {
      const std::int64_t origin = shape == Shape::small ? numbers_.integer(0, 56 * 256) : 0;
      const std::int64_t size = (shape == Shape::small ? 8 : 64) * 256;
      for (std::size_t i = 0; i < 3; ++i) {
        f.positions[i].x = 256 * (origin + numbers_.integer(0, size));
        f.positions[i].y = 256 * (origin + numbers_.integer(0, size));
        f.positions[i].w = Fixed::kOne;
        f.values[i] = numbers_.attribute(1);
        f.w[i] = numbers_.clip_w(bits / 2);
      }
      if (shape == Shape::sliver) flatten(f);
    } while (cross(f.positions[0], f.positions[1], f.positions[2]) == 0);
    place_sample(result);
    return result;
  }

  // Vertices moved by less than kReach each way.
  Interpolant moved(Interpolant f) {
    constexpr std::int64_t kLimit = Fixed::kOne / 256 - 1;
    for (HomogeneousPoint& p : f.positions) {
      p.x += numbers_.integer(-kLimit, kLimit);
      p.y += numbers_.integer(-kLimit, kLimit);
    }
    return f;
  }

  RandomNumbers numbers_{share_seed(20260501)};

 private:
  // The third vertex up to half a pixel beside the line of the two others.
  void flatten(Interpolant& f) {
    const std::int64_t part = numbers_.integer(0, 256);
    const auto beside = [&](std::int64_t a, std::int64_t b) {
      return (a * 256 + part * (b - a)) / (256 * 256) * 256 + 256 * numbers_.integer(-128, 128);
    };
    f.positions[2].x = beside(f.positions[0].x, f.positions[1].x);
    f.positions[2].y = beside(f.positions[0].y, f.positions[1].y);
  }
  void place_sample(Example& example) {
    const auto& p = example.f.positions;
    const double a = numbers_.real(0, 1), b = numbers_.real(0, 1 - a);
    const auto mean = [&](std::int64_t v0, std::int64_t v1, std::int64_t v2) {
      return (static_cast<double>(v0) * a + static_cast<double>(v1) * b +
              static_cast<double>(v2) * (1 - a - b)) /
             Fixed::kOne;
    };
    example.x = std::floor(mean(p[0].x, p[1].x, p[2].x)) + 0.5;
    example.y = std::floor(mean(p[0].y, p[1].y, p[2].y)) + 0.5;
  }
};

struct FloatValues {
  float areas, inverse, planes;
};

// Each form in float32, counted from (x0, y0).
FloatValues in_float32(ProjectedTriangle<float> v, float x, float y, float x0, float y0) {
  for (std::size_t i = 0; i < 3; ++i) {
    v.x[i] -= x0;
    v.y[i] -= y0;
  }
  return {by_area_ratios(v, x - x0, y - y0), by_inverse_matrix(v, x - x0, y - y0),
          AttributePlanes<float>(v).at(x - x0, y - y0)};
}

bool holds(Interval interval, const FloatValues& values) {
  return interval.contains(static_cast<double>(values.areas)) &&
         interval.contains(static_cast<double>(values.inverse)) &&
         interval.contains(static_cast<double>(values.planes));
}

TEST_F(Latitude, InexactHoldsFloat32) {
  for (const Shape shape : kShapes)
    for (int i = 0; i < kScenes; ++i) {
      const Example e = example(shape, i % 2 == 0 ? 0 : 6);
      const auto v = projected<float>(e.f);
      const FloatValues values =
          in_float32(v, static_cast<float>(e.x), static_cast<float>(e.y), v.x[0], v.y[0]);
      ASSERT_TRUE(holds(interpolate_inexact(e.f, e.sample()), values)) << static_cast<int>(shape);
    }
}

TEST_F(Latitude, PermittedHoldsFloat32FromMovedVertices) {
  int bounded = 0;
  for (const Shape shape : kShapes)
    for (int i = 0; i < kScenes; ++i) {
      const Example e = example(shape, i % 2 == 0 ? 0 : 6);
      const Interval permitted = interpolate_permitted(e.f, e.sample(), kReach);
      if (!is_everything(permitted)) ++bounded;
      for (int move = 0; move < 4; ++move) {
        const auto v = projected<float>(moved(e.f));
        const auto x = static_cast<float>(e.x), y = static_cast<float>(e.y);
        ASSERT_TRUE(holds(permitted, in_float32(v, x, y, v.x[0], v.y[0])));
        ASSERT_TRUE(permitted.contains(static_cast<double>(in_float32(v, x, y, 0, 0).planes)));
      }
    }
  EXPECT_GT(bounded, 3 * kScenes * 9 / 10);
}

TEST_F(Latitude, PermittedHoldsInexactHoldsExact) {
  for (const Shape shape : kShapes)
    for (int i = 0; i < share_of(kScenes); ++i) {
      Example e = example(shape, 20);
      if (i % 3 == 0) e.f.kind = PrimitiveKind::line;
      const Interval exact = interpolate_exact(e.f, e.sample());
      const Interval inexact = interpolate_inexact(e.f, e.sample());
      const Interval permitted = interpolate_permitted(e.f, e.sample(), kReach);
      ASSERT_TRUE(holds(inexact, exact));
      ASSERT_TRUE(holds(permitted, inexact));
      ASSERT_TRUE(holds(interpolate_permitted(e.f, e.sample(), 4 * kReach), permitted));
    }
}

// A value that is off by the error of one operation needs no bounds (diff/values/value_judge.h).
TEST_F(Latitude, InexactHoldsTheErrorOfOneOperation) {
  int known = 0;
  for (const Shape shape : kShapes)
    for (int i = 0; i < share_of(kScenes); ++i) {
      Example e = example(shape, i % 2 == 0 ? 0 : 20);
      if (i % 3 == 0) e.f.kind = PrimitiveKind::line;
      e.f.perspective = i % 4 != 0;
      const Interval exact = interpolate_exact(e.f, e.sample());
      const Interval inexact = interpolate_inexact(e.f, e.sample());
      const double error = 0.95e-5 * std::min(std::fabs(exact.low), std::fabs(exact.high));
      if (!(exact.high - exact.low <= 0.01 * error)) continue;
      ASSERT_TRUE(inexact.contains(exact.low - error) && inexact.contains(exact.high + error));
      ++known;
    }
  EXPECT_GT(known, 3 * share_of(kScenes) * 9 / 10);
}

// The same vertices as quotients that no power of two divides.
TEST_F(Latitude, OfQuotientsIsThatOfTheirPositions) {
  for (int i = 0; i < kScenes; ++i) {
    const Example e = example(Shape::ample, 6);
    Interpolant thirds = e.f;
    if (i % 2 == 0) thirds.kind = PrimitiveKind::line;
    Interpolant f = thirds;
    for (HomogeneousPoint& p : thirds.positions) p = {3 * p.x, 3 * p.y, 3 * p.w};
    for (const double reach : {0.0, kReach}) {
      const Interval given = interpolate_permitted(f, e.sample(), reach);
      const Interval other = interpolate_permitted(thirds, e.sample(), reach);
      if (is_everything(given) || is_everything(other)) continue;
      const double rounding = 1e-9 * (1 + given.magnitude() * given.magnitude());
      EXPECT_NEAR(given.low, other.low, rounding);
      EXPECT_NEAR(given.high, other.high, rounding);
    }
  }
}

// Of at least 100 square pixels, and so no thinner than 200/91 in a target of 64; ratios of w below
// 10. A move of 1/256 changes a weight by at most 2 sqrt(2)/256 of that height either way, 1/100
// in all, and perspective makes it at most 4 times as much: within 1/20 of the attribute's range.
// The products of the areas are at most 41 times the area: within 1/200 of the largest value when
// nothing moves. Seen are 1/32 and 1/372.
TEST_F(Latitude, IsNarrowWhereTheConditionIsGood) {
  int seen = 0;
  double worst = 0, worst_inexact = 0;
  for (int i = 0; i < kScenes; ++i) {
    const Example e = example(Shape::ample, 3.3);
    const auto v = projected<double>(e.f);
    if (std::fabs(doubled_area(v.x[0], v.y[0], v.x[1], v.y[1], v.x[2], v.y[2])) < 200) continue;
    ++seen;
    const auto [low, high] = std::minmax_element(v.values.begin(), v.values.end());
    const Interval permitted = interpolate_permitted(e.f, e.sample(), kReach);
    worst = std::max(worst, width_of(permitted) / (*high - *low));
    worst_inexact = std::max(worst_inexact, width_of(interpolate_inexact(e.f, e.sample())));
  }
  EXPECT_GT(seen, kScenes / 2);
  EXPECT_LT(worst, 1.0 / 20);
  EXPECT_LT(worst_inexact, 1.0 / 200);
}

// ------------------------------------------------------------------------------------------ lines

struct FloatLine {
  float x[2], y[2], w[2], values[2];
};

float along(const FloatLine& v, float x, float y) {
  const float dx = v.x[1] - v.x[0], dy = v.y[1] - v.y[0];
  return ((x - v.x[0]) * dx + (y - v.y[0]) * dy) / (dx * dx + dy * dy);
}

// As the specification writes it, and from the first vertex on.
std::array<float, 2> line_in_float32(const Interpolant& f, float x, float y) {
  const auto all = projected<float>(f);
  const FloatLine v{{all.x[0], all.x[1]},
                    {all.y[0], all.y[1]},
                    {all.w[0], all.w[1]},
                    {all.values[0], all.values[1]}};
  const float t = along(v, x, y);
  const float a = (1 - t) / v.w[0], b = t / v.w[1];
  const float divided = v.values[1] / v.w[1] - v.values[0] / v.w[0];
  return {(a * v.values[0] + b * v.values[1]) / (a + b),
          (v.values[0] / v.w[0] + t * divided) / (1 / v.w[0] + t * (1 / v.w[1] - 1 / v.w[0]))};
}

TEST_F(Latitude, OfLinesHoldsFloat32) {
  int bounded = 0;
  for (const Shape shape : {Shape::ample, Shape::small})
    for (int i = 0; i < kScenes; ++i) {
      Example e = example(shape, i % 2 == 0 ? 0 : 4);
      e.f.kind = PrimitiveKind::line;
      // The two vertices, and a pixel near the line.
      e.x = std::floor(static_cast<double>(e.f.positions[0].x + e.f.positions[1].x) / 131072) + 0.5;
      e.y = std::floor(static_cast<double>(e.f.positions[0].y + e.f.positions[1].y) / 131072) + 0.5;
      const auto x = static_cast<float>(e.x), y = static_cast<float>(e.y);
      const Interval inexact = interpolate_inexact(e.f, e.sample());
      const Interval permitted = interpolate_permitted(e.f, e.sample(), kReach);
      if (!is_everything(permitted)) ++bounded;
      for (const float value : line_in_float32(e.f, x, y))
        ASSERT_TRUE(inexact.contains(static_cast<double>(value))) << i;
      for (int move = 0; move < 4; ++move)
        for (const float value : line_in_float32(moved(e.f), x, y))
          ASSERT_TRUE(permitted.contains(static_cast<double>(value))) << i;
    }
  EXPECT_GT(bounded, 2 * kScenes * 9 / 10);
}

}  // namespace
}  // namespace edgecase
