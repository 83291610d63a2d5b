// SPDX-License-Identifier: MIT
//
// Derivatives by every method against their definition: differences of values that are worked out
// in 113 bits at the two pixels, and the derivative of the quotient.
#include "rules/values/derivative.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "tests/oracles/attribute_planes.h"
#include "tests/rules/values/interpolants.h"
#include "tests/support/causes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr int kScenes = 2000;
constexpr double kReach = 1.0 / 256;
constexpr Axis kAxes[] = {Axis::x, Axis::y};
constexpr Derivative kForms[] = {Derivative::x,      Derivative::y,        Derivative::x_fine,
                                 Derivative::y_fine, Derivative::x_coarse, Derivative::y_coarse};

class RandomDerivatives : public ::testing::Test {
 protected:
  // In a target of 16 pixels, w ratios up to 2^`bits`.
  Interpolant triangle(double bits) {
    Interpolant f;
    do {
      for (std::size_t i = 0; i < 3; ++i) {
        f.positions[i] = homogeneous(moved_by(at(8, 8), numbers_.point(Fixed::kOne * 8)));
        f.values[i] = numbers_.attribute(1);
        f.w[i] = numbers_.clip_w(bits / 2);
      }
    } while (area_of(f) < 8);
    return f;
  }
  static double area_of(const Interpolant& f) {
    return std::fabs(static_cast<double>(cross(f.positions[0], f.positions[1], f.positions[2]))) /
           std::ldexp(1, 48);
  }
  static bool covers(const Interpolant& f, PixelPosition pixel) {
    const HomogeneousPoint p = homogeneous_centre(pixel.x, pixel.y);
    int left = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (cross(f.positions[i], f.positions[(i + 1) % 3], p) > 0) ++left;
    return left == 0 || left == 3;
  }
  // A pixel that it covers, or none after some trials.
  bool find_pixel(const Interpolant& f, PixelPosition& pixel) {
    for (int trial = 0; trial < 60; ++trial) {
      pixel = {static_cast<int>(numbers_.integer(0, 15)),
               static_cast<int>(numbers_.integer(0, 15))};
      if (covers(f, pixel)) return true;
    }
    return false;
  }

  RandomNumbers numbers_{share_seed(20260601)};
};

// The value at a pixel's centre.
Wide value_at(const Interpolant& f, int x, int y) {
  return AttributePlanes<Wide>(projected<Wide>(f))
      .at(static_cast<Wide>(x) + Wide(0.5), static_cast<Wide>(y) + Wide(0.5));
}

Wide difference(const Interpolant& f, Axis axis, int x, int y) {
  return (axis == Axis::x ? value_at(f, x + 1, y) : value_at(f, x, y + 1)) - value_at(f, x, y);
}

// Each method's lower or left pixel, as the quad is drawn in rules/values/derivative.h.
Wide by_definition(const Interpolant& f, const QuadPixel& at, Axis axis, DerivativeMethod method) {
  const auto [px, py] = at.pixel;
  const auto [qx, qy] = at.quad;
  const bool x = axis == Axis::x;
  const int left = qx, right = qx + 1, bottom = qy, top = qy + 1;
  const int odd_x = px == qx ? px - 1 : px, odd_y = py == qy ? py - 1 : py;
  switch (method) {
    case DerivativeMethod::analytic: {
      const AttributePlanes<Wide> planes(projected<Wide>(f));
      const Wide sx = static_cast<Wide>(px) + Wide(0.5), sy = static_cast<Wide>(py) + Wide(0.5);
      return x ? planes.slope_x(sx, sy) : planes.slope_y(sx, sy);
    }
    case DerivativeMethod::forward:
      return difference(f, axis, px, py);
    case DerivativeMethod::fine:
      return x ? difference(f, axis, left, py) : difference(f, axis, px, bottom);
    case DerivativeMethod::fine_odd:
      return x ? difference(f, axis, odd_x, py) : difference(f, axis, px, odd_y);
    case DerivativeMethod::other_row:
      return x ? difference(f, axis, left, py == bottom ? top : bottom)
               : difference(f, axis, px == left ? right : left, bottom);
    case DerivativeMethod::coarse_bottom_left:
      return difference(f, axis, left, bottom);
    case DerivativeMethod::coarse_bottom_right:
      return x ? difference(f, axis, left, bottom) : difference(f, axis, right, bottom);
    case DerivativeMethod::coarse_top_left:
      return x ? difference(f, axis, left, top) : difference(f, axis, left, bottom);
    case DerivativeMethod::coarse_top_right:
      return x ? difference(f, axis, left, top) : difference(f, axis, right, bottom);
  }
  return 0;
}

TEST_F(RandomDerivatives, EveryMethodIsWhatItsDefinitionSays) {
  int seen = 0;
  for (int i = 0; i < kScenes; ++i) {
    const Interpolant f = triangle(i % 4 == 0 ? 0 : 4);
    PixelPosition pixel;
    if (!find_pixel(f, pixel)) continue;
    ++seen;
    const QuadPixel at =
        in_quad(pixel, i % 2 == 0 ? RowOrder::top_down : RowOrder::bottom_up, 16 + i / 2 % 2);
    for (const Axis axis : kAxes)
      for (const DerivativeMethod method : values_of<DerivativeMethod>()) {
        const Wide truth = by_definition(f, at, axis, method);
        const Interval exact = derivative_exact(f, at, axis, method);
        // The other pixels may lie where 1/w is nearly 0.
        EXPECT_TRUE(holds(exact, truth)) << name_of(method);
        if (method == DerivativeMethod::analytic) {
          EXPECT_LT(width_of(exact), 1e-11);
        }
      }
  }
  EXPECT_GT(seen, kScenes * 3 / 4);
}

TEST_F(RandomDerivatives, AllMethodsAgreeWhereTheAttributeIsLinear) {
  for (int i = 0; i < kScenes; ++i) {
    Interpolant f = triangle(4);
    f.perspective = i % 2 == 0;
    if (f.perspective) f.w = {3, 3, 3};
    const QuadPixel at = in_quad({i % 16, i / 16 % 16}, RowOrder::bottom_up, 16);
    for (const Axis axis : kAxes) {
      const Interval analytic = derivative_exact(f, at, axis, DerivativeMethod::analytic);
      for (const DerivativeMethod method : values_of<DerivativeMethod>()) {
        const QuadPixel elsewhere = in_quad({i / 16 % 16, i % 16}, RowOrder::top_down, 17);
        for (const QuadPixel& pixel : {at, elsewhere}) {
          const Interval other = derivative_exact(f, pixel, axis, method);
          EXPECT_EQ(other.low, analytic.low) << name_of(method);
          EXPECT_EQ(other.high, analytic.high) << name_of(method);
        }
      }
      EXPECT_LT(width_of(analytic), 1e-11);
      EXPECT_TRUE(holds(analytic, by_definition(f, at, axis, DerivativeMethod::forward)));
    }
  }
}

bool is_open(const Rule& rule, DerivativeMethod method) {
  for (const Alternative& alternative : rule.alternatives)
    if (alternative.name == name_of(method)) return alternative.openness == Openness::open;
  ADD_FAILURE() << rule.id << " does not know " << name_of(method);
  return false;
}

TEST_F(RandomDerivatives, PermittedHoldsEveryOpenMethod) {
  const Rule rules[] = {derivative_rule(), fine_derivative_rule(), coarse_derivative_rule()};
  const int count = share_of(kScenes, 250);
  int seen = 0;
  for (int i = 0; i < count; ++i) {
    const Interpolant f = triangle(i % 4 == 0 ? 0 : i % 16);
    PixelPosition pixel;
    if (!find_pixel(f, pixel)) continue;
    ++seen;
    const QuadPixel at =
        in_quad(pixel, i / 2 % 2 == 0 ? RowOrder::top_down : RowOrder::bottom_up, 16 + i / 4 % 2);
    for (const Derivative derivative : kForms) {
      const Axis axis = axis_of(derivative);
      if ((axis == Axis::x) != (i % 2 == 0)) continue;
      const Interval permitted = PermittedDerivatives(f, kReach).at(pixel, derivative);
      for (const DerivativeMethod method : values_of<DerivativeMethod>()) {
        if (!is_open(rules[form_of(derivative)], method)) continue;
        const Interval inexact = derivative_inexact(f, at, axis, method);
        EXPECT_TRUE(holds(permitted, inexact)) << name_of(derivative) << ' ' << name_of(method);
        EXPECT_TRUE(holds(inexact, derivative_exact(f, at, axis, method))) << name_of(method);
      }
    }
  }
  EXPECT_GT(seen, count * 3 / 4);
}

// Planes counted from the first vertex, all vertices moved alike for the two pixels.
TEST_F(RandomDerivatives, PermittedHoldsFloat32FromMovedVertices) {
  constexpr std::int64_t kLimit = Fixed::kOne / 256 - 1;
  int seen = 0;
  for (int i = 0; i < kScenes; ++i) {
    const Interpolant f = triangle(i % 4 == 0 ? 0 : i % 12);
    PixelPosition pixel;
    if (!find_pixel(f, pixel)) continue;
    ++seen;
    Interpolant moved = f;
    for (HomogeneousPoint& p : moved.positions) {
      p.x += numbers_.integer(-kLimit, kLimit);
      p.y += numbers_.integer(-kLimit, kLimit);
    }
    auto v = projected<float>(moved);
    const float x0 = v.x[0], y0 = v.y[0];
    for (std::size_t k = 0; k < 3; ++k) {
      v.x[k] -= x0;
      v.y[k] -= y0;
    }
    const AttributePlanes<float> planes(v);
    const float x = static_cast<float>(pixel.x) + 0.5F - x0;
    const float y = static_cast<float>(pixel.y) + 0.5F - y0;
    const Interval along_x = PermittedDerivatives(f, kReach).at(pixel, Derivative::x_fine);
    const Interval along_y = PermittedDerivatives(f, kReach).at(pixel, Derivative::y_fine);
    EXPECT_TRUE(along_x.contains(static_cast<double>(planes.at(x + 1, y) - planes.at(x, y))));
    EXPECT_TRUE(along_y.contains(static_cast<double>(planes.at(x, y) - planes.at(x, y - 1))));
    EXPECT_TRUE(along_x.contains(static_cast<double>(planes.slope_x(x, y))));
    EXPECT_TRUE(along_y.contains(static_cast<double>(planes.slope_y(x, y))));
  }
  EXPECT_GT(seen, kScenes * 3 / 4);
}

// An attribute that grows along x (or y), the faster the nearer to the far vertex.
Interpolant towards_the_horizon(Axis axis) {
  if (axis == Axis::x)
    return {PrimitiveKind::triangle,
            {vertex_at(0, 0), vertex_at(16, 0), vertex_at(0, 16)},
            {0, 1, 0},
            {1, 1, 16}};
  return {PrimitiveKind::triangle,
          {vertex_at(0, 0), vertex_at(16, 0), vertex_at(0, 16)},
          {0, 0, 1},
          {1, 16, 1}};
}

TEST(DerivativePermitted, TheOtherRowIsNoFineForm) {
  for (const Axis axis : kAxes) {
    const Interpolant f = towards_the_horizon(axis);
    const PixelPosition pixel = axis == Axis::x ? PixelPosition{0, 14} : PixelPosition{14, 0};
    const QuadPixel at = in_quad(pixel, RowOrder::bottom_up, 16);
    const Interval other = derivative_inexact(f, at, axis, DerivativeMethod::other_row);
    const auto of = [&](Derivative x, Derivative y) {
      return PermittedDerivatives(f, kReach).at(pixel, axis == Axis::x ? x : y);
    };
    const Interval fine = of(Derivative::x_fine, Derivative::y_fine);
    EXPECT_GT(other.low, fine.high);
    EXPECT_TRUE(holds(of(Derivative::x, Derivative::y), other));
    EXPECT_TRUE(holds(of(Derivative::x_coarse, Derivative::y_coarse), other));
    // Nor is a difference of two pixels, or of none.
    const Interval own = derivative_exact(f, at, axis, DerivativeMethod::fine);
    EXPECT_FALSE(fine.contains(2 * own.low));
    EXPECT_FALSE(fine.contains(0));
  }
}

TEST(DerivativePermitted, TwoRowsAwayIsNoForm) {
  for (const Axis axis : kAxes) {
    const Interpolant f = towards_the_horizon(axis);
    const auto beside = [&](int rows) {
      return axis == Axis::x ? PixelPosition{1, 12 + rows} : PixelPosition{12 + rows, 1};
    };
    const auto difference_at = [&](PixelPosition pixel) {
      return derivative_exact(f, {pixel, pixel}, axis, DerivativeMethod::forward);
    };
    for (const Derivative derivative : kForms) {
      if (axis_of(derivative) != axis) continue;
      const Interval permitted = PermittedDerivatives(f, kReach).at(beside(0), derivative);
      for (const int rows : {-2, 2})
        EXPECT_FALSE(holds(permitted, difference_at(beside(rows)))) << name_of(derivative);
      for (const int rows : {-1, 1})
        EXPECT_EQ(holds(permitted, difference_at(beside(rows))), form_of(derivative) != 1);
    }
  }
}

// 1/w changes its sign beside the pixel: the differences on both sides of it have other signs than
// the derivative, which is permitted all the same.
TEST(DerivativePermitted, BesideTheHorizonTheDerivativeItselfIsPermitted) {
  // 1/w is 1 - 15x/64, which is 0 at x = 4.27; (1 - x/4) / (1 - 15x/64).
  for (const PrimitiveKind kind : {PrimitiveKind::line, PrimitiveKind::triangle}) {
    const Interpolant f{
        kind, {vertex_at(0, 0.5), vertex_at(4, 0.5), vertex_at(0, 4)}, {1, 0, 1}, {1, 16, 1}};
    const PixelPosition pixel{3, 0};
    const Interval permitted = PermittedDerivatives(f, kReach).at(pixel, Derivative::x_fine);
    const QuadPixel at = in_quad(pixel, RowOrder::bottom_up, 8);
    const Interval analytic = derivative_exact(f, at, Axis::x, DerivativeMethod::analytic);
    EXPECT_LT(analytic.high, 0);
    EXPECT_GT(derivative_exact(f, at, Axis::x, DerivativeMethod::forward).low, 0);
    EXPECT_TRUE(holds(permitted, analytic));
    EXPECT_LT(width_of(permitted), 10);
  }
}

TEST(DerivativePermitted, TheFineFormHasFourOpenMethods) {
  const Rule fine = fine_derivative_rule();
  std::set<std::string> open;
  for (const DerivativeMethod method : values_of<DerivativeMethod>()) {
    if (is_open(fine, method)) open.insert(name_of(method));
    EXPECT_TRUE(is_open(derivative_rule(), method));
    EXPECT_TRUE(is_open(coarse_derivative_rule(), method));
  }
  EXPECT_EQ(open, (std::set<std::string>{"analytic", "forward", "quad-fine", "quad-fine-odd"}));
}

// Three pixels to all sides, and no farther: what the differences of neighbours there have in
// common with the permitted interval, for vertices that hardly move.
TEST(DerivativePermitted, InAnAreaOfFourByFour) {
  const PixelPosition pixel{4, 5};
  for (const Axis axis : kAxes) {
    const Interpolant f = towards_the_horizon(axis);
    Interval expected(HUGE_VAL, -HUGE_VAL);
    for (int across = -3; across <= 3; ++across)
      for (int along = -3; along < 3; ++along) {
        const PixelPosition at = axis == Axis::x ? PixelPosition{pixel.x + along, pixel.y + across}
                                                 : PixelPosition{pixel.x + across, pixel.y + along};
        expected = hull(expected, derivative_exact(f, {at, at}, axis, DerivativeMethod::forward));
      }
    for (const Derivative derivative :
         {axis == Axis::x ? Derivative::x : Derivative::y,
          axis == Axis::x ? Derivative::x_coarse : Derivative::y_coarse}) {
      PermittedDerivatives permitted(f, 0x1p-20);
      const Interval found = permitted.in_area(pixel, derivative);
      EXPECT_TRUE(holds(found, expected)) << name_of(derivative);
      EXPECT_LT(width_of(found), 1.05 * width_of(expected)) << name_of(derivative);
      EXPECT_LT(width_of(permitted.at(pixel, derivative)), 0.7 * width_of(expected));
    }
  }
}

}  // namespace
}  // namespace edgecase
