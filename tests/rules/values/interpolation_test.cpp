// SPDX-License-Identifier: MIT
//
// Interpolation against the formulas themselves, worked out again here: the exact side in 113-bit
// floating point, the permitted side at every corner of the moves that the vertices may make.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct WidePoint {
  Wide x;
  Wide y;
};

using WideTriangle = std::array<WidePoint, 3>;

WidePoint wide(const HomogeneousPoint& p) {
  return {static_cast<Wide>(p.x) / p.w, static_cast<Wide>(p.y) / p.w};
}
WidePoint wide(Point p) {
  return wide(homogeneous(p));
}

Wide cross_of(WidePoint a, WidePoint b, WidePoint p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

Wide on_triangle(const WideTriangle& v, const std::array<Interval, 3>& values, WidePoint p) {
  const Wide sum = cross_of(v[1], v[2], p) * values[0].low +
                   cross_of(v[2], v[0], p) * values[1].low +
                   cross_of(v[0], v[1], p) * values[2].low;
  return sum / cross_of(v[0], v[1], v[2]);
}

Wide on_line(const Interpolant& f, WidePoint p) {
  const WidePoint a = wide(f.positions[0]);
  const WidePoint b = wide(f.positions[1]);
  const Wide dx = b.x - a.x;
  const Wide dy = b.y - a.y;
  const auto size = [](Wide value) { return value < 0 ? -value : value; };
  Wide t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  if (f.line_parameter == LineParameter::major_axis)
    t = size(dx) >= size(dy) ? (p.x - a.x) / dx : (p.y - a.y) / dy;
  return f.values[0].low + t * (static_cast<Wide>(f.values[1].low) - f.values[0].low);
}

void expect_everything(Interval interval) {
  EXPECT_EQ(interval.low, -kInfinity);
  EXPECT_EQ(interval.high, kInfinity);
}

// Holds the truth, and little else.
void expect_at(Interval interval, Wide truth, double width) {
  EXPECT_LE(static_cast<Wide>(interval.low), truth) << static_cast<double>(truth);
  EXPECT_GE(static_cast<Wide>(interval.high), truth) << static_cast<double>(truth);
  EXPECT_LE(interval.high - interval.low, width);
}

class RandomInterpolants : public ::testing::Test {
 protected:
  Fixed coordinate(std::int64_t limit) {
    return Fixed::from_raw(std::uniform_int_distribution<std::int64_t>(-limit, limit)(engine_));
  }
  Interpolant interpolant(PrimitiveKind kind, std::int64_t limit) {
    Interpolant f;
    f.kind = kind;
    for (HomogeneousPoint& p : f.positions) {
      const Fixed x = coordinate(limit);
      p = homogeneous({x, coordinate(limit)});
    }
    for (Interval& value : f.values) value = std::uniform_real_distribution<>(-2, 2)(engine_);
    return f;
  }
  std::mt19937_64 engine_{20260201};
};

TEST_F(RandomInterpolants, ExactHoldsTheFormulaOnTriangles) {
  int seen = 0;
  for (int i = 0; i < 3000; ++i) {
    // Small ones, and some whose areas leave 53 bits.
    const std::int64_t limit = i % 3 == 0 ? Fixed::kOne * 8192 : Fixed::kOne * 8;
    const Interpolant f = interpolant(PrimitiveKind::triangle, limit);
    const WideTriangle v{wide(f.positions[0]), wide(f.positions[1]), wide(f.positions[2])};
    const Wide area = cross_of(v[0], v[1], v[2]);
    if ((area < 0 ? -area : area) < 8) continue;
    ++seen;
    const Point sample{coordinate(limit), coordinate(limit)};
    expect_at(interpolate_exact(f, sample), on_triangle(v, f.values, wide(sample)), 1e-7);
  }
  EXPECT_GT(seen, 2000);
}

TEST_F(RandomInterpolants, ExactHoldsTheFormulaOnLines) {
  for (int i = 0; i < 4000; ++i) {
    const std::int64_t limit = i % 3 == 0 ? Fixed::kOne * 8192 : Fixed::kOne * 8;
    Interpolant f = interpolant(PrimitiveKind::line, limit);
    if (i % 2 == 0) f.line_parameter = LineParameter::major_axis;
    if (i % 8 == 1) f.positions[1].y = f.positions[0].y;
    if (i % 8 == 2) f.positions[1].x = f.positions[0].x;
    // 45 degrees counts as x-major.
    if (i % 8 == 4) f.positions[1].y = f.positions[0].y + (f.positions[1].x - f.positions[0].x);
    const Point sample{coordinate(limit), coordinate(limit)};
    const Wide truth = on_line(f, wide(sample));
    const double size = std::fabs(static_cast<double>(truth)) + 4;
    expect_at(interpolate_exact(f, sample), truth, 1e-13 * size);
  }
}

// Products beyond 2^53 are no doubles. In these two their roundings add up to more than what the
// operations after them allow for, unless the products are ranges.
TEST(Interpolation, ProductsAreRoundedOutwards) {
  struct Example {
    std::int64_t rise, sample_rise;  // raw, from the start
    double start, end;
  };
  for (const Example& e :
       {Example{120785085, 99895726, -0x1.ec00cefda5fbcp+0, 0x1.3521a82e9f6ddp-6},
        Example{97992158, 95226794, -0x1.ed039ccaf1e76p+0, 0x1.45b297be8aacdp-9}}) {
    const Fixed y = Fixed::from_integer(-4096);
    const Fixed left = Fixed::from_integer(-8192);
    const Fixed right = Fixed::from_integer(8192);
    const Interpolant f{PrimitiveKind::line,
                        {homogeneous({left, y}), homogeneous({right, y + Fixed::from_raw(e.rise)})},
                        {e.start, e.end}};
    const Point sample{right, y + Fixed::from_raw(e.sample_rise)};
    expect_at(interpolate_exact(f, sample), on_line(f, wide(sample)), 1e-14);
  }
}

TEST(Interpolation, WithoutExtentNothingIsKnown) {
  Interpolant f{
      PrimitiveKind::line, {vertex_at(1, 2), vertex_at(1, 2), vertex_at(5, 5)}, {0, 1, 2}};
  expect_everything(interpolate_exact(f, at(1.5, 2.5)));
  f.kind = PrimitiveKind::triangle;
  expect_everything(interpolate_exact(f, at(1.5, 2.5)));
  expect_everything(interpolate_permitted(f, at(1.5, 2.5), reach_of(8)));
}

TEST(Interpolation, APointHasTheValueOfItsVertex) {
  const Interpolant f{
      PrimitiveKind::point, {vertex_at(1, 2), vertex_at(3, 4), vertex_at(5, 6)}, {0.25, 0.5, 0.75}};
  for (const Interval value :
       {interpolate_exact(f, at(1.5, 2.5)), interpolate_permitted(f, at(1.5, 2.5), reach_of(8))}) {
    EXPECT_EQ(value.low, 0.25);
    EXPECT_EQ(value.high, 0.25);
  }
}

TEST(Interpolation, AllVerticesCountForAConstant) {
  // A line has two values; the third one of the array is no part of it.
  const Interpolant line{
      PrimitiveKind::line, {vertex_at(0, 0), vertex_at(4, 0), {}}, {0.1, 0.1, 9}};
  EXPECT_EQ(interpolate_exact(line, at(1.5, 0.5)).low, 0.1);
  EXPECT_EQ(interpolate_exact(line, at(1.5, 0.5)).high, 0.1);
  const Interpolant triangle{
      PrimitiveKind::triangle, {vertex_at(0, 0), vertex_at(4, 0), vertex_at(0, 4)}, {1, 1, 9}};
  EXPECT_TRUE(interpolate_exact(triangle, at(0.5, 1.5)).contains(4));
}

// ------------------------------------------------------------------------------- what is permitted

// The least and greatest value that moves of `step` at the corners of each vertex's square make.
Interval hull_of_moves(const Interpolant& f, Point sample, double step) {
  double low = kInfinity;
  double high = -kInfinity;
  for (int moves = 0; moves < 64; ++moves) {
    WideTriangle v;
    for (std::size_t i = 0; i < 3; ++i) {
      const int bits = moves >> (2 * i) & 3;
      v[i] = wide(f.positions[i]);
      v[i].x += (bits & 1) == 0 ? step : -step;
      v[i].y += (bits & 2) == 0 ? step : -step;
    }
    const auto value = static_cast<double>(on_triangle(v, f.values, wide(sample)));
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return {low, high};
}

// Well-shaped triangles with sides of some pixels and moves of 1/4: what the moves permit is a
// hundred times what the rounding of 1 part in 10^5 adds.
TEST_F(RandomInterpolants, PermittedIsTheHullOfAllMovesOnTriangles) {
  for (int i = 0; i < 300; ++i) {
    Interpolant f = interpolant(PrimitiveKind::triangle, Fixed::kOne);
    const bool clockwise = i % 2 == 0;
    const Point corners[] = {at(0, 0), at(9, 1), at(2, 8)};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point corner = corners[clockwise ? 2 - k : k];
      f.positions[k].x += corner.x.raw();
      f.positions[k].y += corner.y.raw();
    }
    const Point sample{coordinate(Fixed::kOne * 4) + Fixed::from_integer(4),
                       coordinate(Fixed::kOne * 4) + Fixed::from_integer(3)};
    const Interval hull = hull_of_moves(f, sample, 0.25);
    const Interval permitted = interpolate_permitted(f, sample, reach_of(2));
    EXPECT_LE(permitted.low, hull.low);
    EXPECT_GE(permitted.high, hull.high);
    EXPECT_NEAR(permitted.low, hull.low, 4e-3);
    EXPECT_NEAR(permitted.high, hull.high, 4e-3);
  }
}

TEST(Permitted, EverythingWhereAMoveTakesTheArea) {
  // Three quarters of a pixel high: moves of half a pixel at both ends turn it over.
  const Interpolant flat{
      PrimitiveKind::triangle, {vertex_at(0, 0), vertex_at(8, 0), vertex_at(4, 0.75)}, {0, 1, 0.5}};
  expect_everything(interpolate_permitted(flat, at(4.5, 0.5), reach_of(1)));
  EXPECT_LT(interpolate_permitted(flat, at(4.5, 0.5), reach_of(4)).high, kInfinity);
  const Interpolant turned{
      PrimitiveKind::triangle, {vertex_at(8, 0), vertex_at(0, 0), vertex_at(4, 0.75)}, {1, 0, 0.5}};
  expect_everything(interpolate_permitted(turned, at(4.5, 0.5), reach_of(1)));
  EXPECT_GT(interpolate_permitted(turned, at(4.5, 0.5), reach_of(4)).low, -kInfinity);
  // Exactly none left: a height of 1, both sides moved by 1/2.
  const Interpolant spent{
      PrimitiveKind::triangle, {vertex_at(0, 0), vertex_at(8, 0), vertex_at(4, 1)}, {0, 1, 0.5}};
  expect_everything(interpolate_permitted(spent, at(4.5, 0.5), reach_of(1)));
}

TEST(Permitted, SmallTrianglesKeepTheirSign) {
  // An eighth of a square pixel, far more than moves of 1/256 can take.
  Interpolant f{PrimitiveKind::triangle,
                {vertex_at(4.25, 4.25), vertex_at(4.75, 4.25), vertex_at(4.25, 4.75)},
                {0, 1, 0}};
  for (int winding = 0; winding < 2; ++winding) {
    const Interval permitted = interpolate_permitted(f, at(4.5, 4.5), reach_of(8));
    EXPECT_TRUE(permitted.contains(0.5));
    EXPECT_LT(permitted.high - permitted.low, 0.1);
    std::swap(f.positions[0], f.positions[1]);
    std::swap(f.values[0], f.values[1]);
  }
}

TEST(Permitted, EverythingWhereASmallTriangleMayTurnOver) {
  Interpolant f{PrimitiveKind::triangle,
                {vertex_at(4.25, 4.25), vertex_at(4.75, 4.25), vertex_at(4.25, 4.75)},
                {0, 1, 0}};
  for (int winding = 0; winding < 2; ++winding) {
    expect_everything(interpolate_permitted(f, at(4.5, 4.5), reach_of(2)));
    std::swap(f.positions[0], f.positions[1]);
    std::swap(f.values[0], f.values[1]);
  }
}

TEST(Permitted, EverythingOfTheSmallestTriangle) {
  const double unit = 1.0 / 65536;
  Interpolant f{
      PrimitiveKind::triangle,
      {vertex_at(2.25, 3.25), vertex_at(2.25 + unit, 3.25 - unit), vertex_at(2.25, 3.25 + unit)},
      {0.1, 1, 0.3}};
  for (int winding = 0; winding < 2; ++winding) {
    for (const Point sample : {at(1.75, 3.375), at(2.5, 3.5), at(3.0, 3.125)})
      for (int bits : {1, 4, 8})
        expect_everything(interpolate_permitted(f, sample, reach_of(bits)));
    std::swap(f.positions[0], f.positions[1]);
    std::swap(f.values[0], f.values[1]);
  }
}

// The shortest line and the smallest triangle that there are.
TEST(Interpolation, OfOneRawUnit) {
  const double unit = 1.0 / 65536;
  for (const double sign : {-1.0, 1.0}) {
    const Interpolant along{
        PrimitiveKind::line, {vertex_at(4.5, 4.5), vertex_at(4.5 + sign * unit, 4.5)}, {1, 3}};
    expect_at(interpolate_exact(along, at(4.5, 4.5)), 1, 1e-9);
    const Interpolant up{
        PrimitiveKind::line, {vertex_at(4.5, 4.5), vertex_at(4.5, 4.5 + sign * unit)}, {1, 3}};
    expect_at(interpolate_exact(up, at(4.5, 4.5)), 1, 1e-9);
    const Interpolant triangle{
        PrimitiveKind::triangle,
        {vertex_at(4.5, 4.5), vertex_at(4.5 + sign * unit, 4.5), vertex_at(4.5, 4.5 + unit)},
        {1, 3, 5}};
    expect_at(interpolate_exact(triangle, at(4.5, 4.5)), 1, 1e-9);
    expect_everything(interpolate_permitted(triangle, at(4.5, 4.5), reach_of(8)));
  }
}

// Along an axis the quotient is (p - a) / (b - a) with each end somewhere in its range.
TEST(Permitted, LinesByTheMajorAxis) {
  for (const bool vertical : {false, true})
    for (const bool back : {false, true}) {
      const HomogeneousPoint start = vertical ? vertex_at(3, 2) : vertex_at(2, 3);
      const HomogeneousPoint end = vertical ? vertex_at(4, 10) : vertex_at(10, 4);
      Interpolant f{PrimitiveKind::line, {start, end, {}}, {1, 3, 7}};
      if (back) {
        std::swap(f.positions[0], f.positions[1]);
        std::swap(f.values[0], f.values[1]);
      }
      f.line_parameter = LineParameter::major_axis;
      const Point sample = vertical ? at(3.5, 5.5) : at(5.5, 3.5);
      const Interval permitted = interpolate_permitted(f, sample, reach_of(2));
      // 3.5 of 8 from the low end, 4.5 from the high one; each vertex moves by 1/4.
      const double low = back ? 3 - 2 * (4.75 / 7.5) : 1 + 2 * (3.25 / 8.5);
      const double high = back ? 3 - 2 * (4.25 / 8.5) : 1 + 2 * (3.75 / 7.5);
      EXPECT_NEAR(permitted.low, low, 1e-3) << vertical << back;
      EXPECT_NEAR(permitted.high, high, 1e-3) << vertical << back;
    }
}

// By projection, each of the four differences somewhere in its range of 1/4 or 1/2 either way.
TEST(Permitted, LinesByProjection) {
  for (const bool vertical : {false, true}) {
    const Interpolant f{PrimitiveKind::line,
                        {vertical ? vertex_at(3, 2) : vertex_at(2, 3),
                         vertical ? vertex_at(3, 10) : vertex_at(10, 3),
                         {}},
                        {1, 3, 7}};
    // Half a pixel aside of the line, 3.5 along it.
    const Point sample = vertical ? at(3.5, 5.5) : at(5.5, 3.5);
    const Interval permitted = interpolate_permitted(f, sample, reach_of(2));
    // Along: [3.25, 3.75] [7.5, 8.5]; across: [0.25, 0.75] [-0.5, 0.5]; squares: [7.5, 8.5]^2 and,
    // as an interval times itself, [-0.25, 0.25].
    const double low = 1 + 2 * (3.25 * 7.5 - 0.75 * 0.5) / (8.5 * 8.5 + 0.25);
    const double high = 1 + 2 * (3.75 * 8.5 + 0.75 * 0.5) / (7.5 * 7.5 - 0.25);
    EXPECT_NEAR(permitted.low, low, 1e-3) << vertical;
    EXPECT_NEAR(permitted.high, high, 1e-3) << vertical;
  }
}

// 45 degrees counts as x-major.
TEST(Permitted, DiagonalLinesGoByX) {
  Interpolant f{PrimitiveKind::line, {vertex_at(2, 2), vertex_at(10, 10), {}}, {1, 3, 7}};
  f.line_parameter = LineParameter::major_axis;
  const Interval permitted = interpolate_permitted(f, at(5.5, 8.5), reach_of(2));
  EXPECT_NEAR(permitted.low, 1 + 2 * (3.25 / 8.5), 1e-3);
  EXPECT_NEAR(permitted.high, 1 + 2 * (3.75 / 7.5), 1e-3);
}

// The other axis is the one that the major axis is not: nearly at 45 degrees, the one that it may
// be.
TEST(Permitted, TheMinorAxisIsTheOther) {
  Interpolant f{PrimitiveKind::line, {vertex_at(2, 2), vertex_at(10, 10), {}}, {1, 3, 7}};
  f.line_parameter = LineParameter::minor_axis;
  EXPECT_FALSE(goes_by_x(f));
  EXPECT_TRUE(interpolate_exact(f, at(5.5, 8.5)).contains(1 + 2 * (6.5 / 8)));
  EXPECT_TRUE(interpolate_inexact(f, at(5.5, 8.5)).contains(1 + 2 * (6.5 / 8)));
  EXPECT_FALSE(interpolate_inexact(f, at(5.5, 8.5)).contains(1 + 2 * (3.5 / 8)));
  f.positions[1] = vertex_at(6, 10);
  EXPECT_TRUE(goes_by_x(f));
  EXPECT_TRUE(interpolate_exact(f, at(5.5, 8.5)).contains(1 + 2 * (3.5 / 4)));
  EXPECT_TRUE(differentiate_exact(f, at(5.5, 8.5), Axis::x).contains(0.5));
  EXPECT_TRUE(differentiate_inexact(f, at(5.5, 8.5), Axis::y).contains(0));
}

TEST(Permitted, AxesMaySwapNearTheDiagonalAlone) {
  Interpolant f{PrimitiveKind::line, {vertex_at(2, 2), vertex_at(10, 10), {}}, {1, 3, 7}};
  EXPECT_TRUE(may_swap_axes(f, 0));
  f.positions[1] = vertex_at(10, 10.25);
  EXPECT_TRUE(may_swap_axes(f, reach_of(4)));
  EXPECT_FALSE(may_swap_axes(f, reach_of(5)));
  f.positions[1] = vertex_at(-6.25, 10);
  EXPECT_TRUE(may_swap_axes(f, reach_of(4)));
  EXPECT_FALSE(may_swap_axes(f, reach_of(5)));
}

// A division by w and a multiplication by it, and nothing more; whatever the qualifier (14.4).
TEST(Permitted, APointMayErrTwiceByItsW) {
  for (const bool perspective : {true, false}) {
    Interpolant f{PrimitiveKind::point, {vertex_at(1, 2), {}, {}}, {0.75, 0, 0}, {3, 1, 1}};
    f.perspective = perspective;
    const Interval permitted = interpolate_permitted(f, at(1.5, 2.5), reach_of(8));
    EXPECT_TRUE(permitted.contains(0.75 * (1 + 1.9e-5))) << perspective;
    EXPECT_TRUE(permitted.contains(0.75 * (1 - 1.9e-5))) << perspective;
    EXPECT_FALSE(permitted.contains(0.75 * (1 + 2.1e-5))) << perspective;
    EXPECT_FALSE(permitted.contains(0.75 * (1 - 2.1e-5))) << perspective;
    f.w[0] = 1;
    const Interval given = interpolate_permitted(f, at(1.5, 2.5), reach_of(8));
    EXPECT_EQ(given.low, 0.75) << perspective;
    EXPECT_EQ(given.high, 0.75) << perspective;
  }
}

// Each operation may err by 1 part in 10^5, and no vertex moves: at 16 bits by 2^-16 at most.
TEST(Permitted, RoundingIsOnePartInTenToTheFive) {
  const Interpolant line{PrimitiveKind::line, {vertex_at(0, 0), vertex_at(4096, 0), {}}, {0, 1, 0}};
  const Interval permitted = interpolate_permitted(line, at(2048.5, 0.5), reach_of(16));
  const double width = permitted.high - permitted.low;
  // Some ten operations of a value near 1/2.
  EXPECT_GT(width, 2e-5);
  EXPECT_LT(width, 2e-4);
}

}  // namespace
}  // namespace edgecase
