// SPDX-License-Identifier: MIT
//
// The latitude of slopes, and of a point's attributes: it holds the derivative itself, from
// vertices that stay or move, and is not much wider than the errors of its operations.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kReach = 1.0 / 256;
constexpr int kScenes = 2000;

class Slopes : public ::testing::Test {
 protected:
  // Legs of 16 pixels or more, with the samples inside: no slope is steep, no 1/w near zero.
  Interpolant triangle(bool perspective) {
    Interpolant f;
    const double x = numbers_.real(8, 10), y = numbers_.real(8, 10);
    const auto corner = [&](double dx, double dy) {
      return vertex_at(std::floor(256 * (x + dx + numbers_.real(0, 4))) / 256,
                       std::floor(256 * (y + dy + numbers_.real(0, 4))) / 256);
    };
    f.positions = {corner(0, 0), corner(20, 0), corner(0, 20)};
    give_values(f, perspective);
    return f;
  }
  Interpolant line(bool perspective, LineParameter parameter) {
    Interpolant f = triangle(perspective);
    f.kind = PrimitiveKind::line;
    f.line_parameter = parameter;
    // Along any direction, diagonals among them.
    const int dx = static_cast<int>(numbers_.integer(-2, 2)) * 16;
    const int dy = static_cast<int>(numbers_.integer(-2, 2)) * 16;
    f.positions[0] = vertex_at(15.25, 16.5);
    f.positions[1] = dx == 0 && dy == 0 ? vertex_at(31.25, 16.5) : vertex_at(15.25 + dx, 16.5 + dy);
    return f;
  }
  Interpolant moved(Interpolant f) {
    for (HomogeneousPoint& p : f.positions) {
      p.x += numbers_.integer(-1, 1) * (Fixed::kOne / 256 - 1);
      p.y += numbers_.integer(-1, 1) * (Fixed::kOne / 256 - 1);
    }
    return f;
  }
  Point sample() {
    return at(static_cast<double>(numbers_.integer(15, 18)) + 0.5,
              static_cast<double>(numbers_.integer(15, 18)) + 0.5);
  }

  RandomNumbers numbers_{20261121};

 private:
  void give_values(Interpolant& f, bool perspective) {
    for (std::size_t i = 0; i < 3; ++i) {
      f.values[i] = numbers_.attribute(1);
      f.w[i] = perspective ? numbers_.clip_w(1) : 1;
    }
  }
};

// Apart from what the exact side itself does not know, far below any float32.
bool nearly_holds(Interval outer, Interval inner) {
  return holds(outer + Interval(-1e-12, 1e-12), inner);
}

constexpr Axis kAxes[] = {Axis::x, Axis::y};

TEST_F(Slopes, OfTrianglesAreHeldAndNarrow) {
  for (int i = 0; i < kScenes; ++i) {
    const Interpolant f = triangle(i % 2 == 0);
    const Point p = sample();
    for (const Axis axis : kAxes) {
      const Interval exact = differentiate_exact(f, p, axis);
      const Interval inexact = differentiate_inexact(f, p, axis);
      const Interval permitted = differentiate_permitted(f, p, axis, kReach);
      ASSERT_TRUE(nearly_holds(inexact, exact)) << i;
      ASSERT_LT(width_of(inexact), 0.1) << i;
      ASSERT_TRUE(holds(permitted, inexact)) << i;
      ASSERT_LT(width_of(permitted), 0.25) << i;
      for (int move = 0; move < 4; ++move)
        ASSERT_TRUE(nearly_holds(permitted, differentiate_exact(moved(f), p, axis))) << i;
    }
  }
}

// Where every value is 1 but the first, whose own is 0, the slope is that of the total alone.
TEST_F(Slopes, PermittedFollowsTheTotalOverTheMoves) {
  Interpolant f;
  f.positions = {vertex_at(2, 2), vertex_at(3, 2), vertex_at(2, 3)};
  f.values = {0, 1, 0};
  constexpr double kFar = 1.0 / 8;
  const Interval permitted = differentiate_permitted(f, at(2.5, 2.5), Axis::x, kFar);
  // The leg along x is one pixel, and a quarter shorter or longer at the ends of the moves.
  for (const double shorter : {-kFar, kFar}) {
    f.positions[0] = vertex_at(2 + shorter, 2);
    f.positions[1] = vertex_at(3 - shorter, 2);
    EXPECT_TRUE(holds(permitted, differentiate_exact(f, at(2.5, 2.5), Axis::x)));
  }
}

TEST_F(Slopes, OfLinesAreHeldAndNarrow) {
  for (const LineParameter parameter : {LineParameter::projection, LineParameter::major_axis})
    for (int i = 0; i < kScenes; ++i) {
      const Interpolant f = line(i % 2 == 0, parameter);
      const Point p = sample();
      for (const Axis axis : kAxes) {
        const Interval exact = differentiate_exact(f, p, axis);
        const Interval inexact = differentiate_inexact(f, p, axis);
        ASSERT_TRUE(nearly_holds(inexact, exact)) << i;
        ASSERT_LT(width_of(inexact), 0.1) << i;
        ASSERT_TRUE(nearly_holds(differentiate_permitted(f, p, axis, kReach), inexact)) << i;
      }
    }
}

// Divided by w and multiplied again, each with its error: only where w is not 1.
TEST(PointLatitude, IsThatOfTwoOperations) {
  Interpolant f;
  f.kind = PrimitiveKind::point;
  f.values = {0.75, 9, 9};
  f.w = {3, 5, 7};
  const Interval divided = interpolate_inexact(f, at(0.5, 0.5));
  EXPECT_TRUE(divided.contains(0.75));
  EXPECT_GT(width_of(divided), 2 * 0.75 * 1e-5);
  EXPECT_LT(width_of(divided), 5 * 0.75 * 1e-5);
  EXPECT_TRUE(holds(interpolate_permitted(f, at(0.5, 0.5), kReach), divided));
  f.w[0] = 1;
  EXPECT_EQ(width_of(interpolate_inexact(f, at(0.5, 0.5))), 0);
  // A point's data are its vertex's whatever the qualifier (14.4).
  f.w[0] = 3;
  f.perspective = false;
  EXPECT_EQ(width_of(interpolate_inexact(f, at(0.5, 0.5))), width_of(divided));
}

}  // namespace
}  // namespace edgecase
