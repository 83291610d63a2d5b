// SPDX-License-Identifier: MIT
//
// What holds of every interpolation, whatever the numbers: weights sum to one, the order of the
// vertices does not matter, constants stay, equal w are no perspective.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rules/values/derivative.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr int kScenes = 3000;
// Of a sample inside and values of at most 1: 32 2^-53 times the spread of the sum, which is 2
// (tests/rules/values/interpolation_oracles_test.cpp).
constexpr double kNarrow = 0x1p-47;

class InterpolationProperties : public ::testing::Test {
 protected:
  // Corners of an ample triangle or line, moved a little, and a sample inside.
  Interpolant ample(PrimitiveKind kind) {
    Interpolant f;
    f.kind = kind;
    f.positions = {vertex_at(0, 0), vertex_at(14, 2), vertex_at(3, 13)};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point move = numbers_.point(Fixed::kOne * 2);
      f.positions[i].x += move.x.raw();
      f.positions[i].y += move.y.raw();
      f.w[i] = numbers_.clip_w(8);
      f.values[i] = numbers_.attribute(1);
    }
    if (numbers_.one_in(2)) std::swap(f.positions[1], f.positions[2]);
    return f;
  }
  Point inside() { return moved_by(at(5.5, 5), numbers_.point(Fixed::kOne / 2)); }

  RandomNumbers numbers_{20260401};
};

Interpolant with_values(Interpolant f, const std::array<Interval, 3>& values) {
  f.values = values;
  return f;
}

bool same(Interval a, Interval b) {
  return a.low == b.low && a.high == b.high;
}

bool overlap(Interval a, Interval b) {
  return a.low <= b.high && b.low <= a.high;
}

TEST_F(InterpolationProperties, BarycentricsSumToOne) {
  for (int i = 0; i < kScenes; ++i) {
    Interpolant f = ample(i % 2 == 0 ? PrimitiveKind::triangle : PrimitiveKind::line);
    f.perspective = i % 4 < 2;
    const Point sample = inside();
    Interval sum = interpolate_exact(with_values(f, {1, 0, 0}), sample) +
                   interpolate_exact(with_values(f, {0, 1, 0}), sample);
    if (f.kind == PrimitiveKind::triangle)
      sum = sum + interpolate_exact(with_values(f, {0, 0, 1}), sample);
    EXPECT_TRUE(sum.contains(1));
    EXPECT_LT(width_of(sum), 3 * kNarrow);
  }
}

// Both intervals hold the exact value, and both are narrow.
TEST_F(InterpolationProperties, TheOrderOfTheVerticesDoesNotMatter) {
  for (int i = 0; i < kScenes; ++i) {
    const Interpolant f = ample(PrimitiveKind::triangle);
    const Point sample = inside();
    const Interval given = interpolate_exact(f, sample);
    std::array<std::size_t, 3> order{0, 1, 2};
    while (std::next_permutation(order.begin(), order.end())) {
      Interpolant other = f;
      for (std::size_t k = 0; k < 3; ++k) {
        other.positions[k] = f.positions[order[k]];
        other.values[k] = f.values[order[k]];
        other.w[k] = f.w[order[k]];
      }
      const Interval permuted = interpolate_exact(other, sample);
      EXPECT_TRUE(overlap(given, permuted));
      EXPECT_LT(width_of(hull(given, permuted)), 2 * kNarrow);
    }
  }
}

TEST_F(InterpolationProperties, TheDirectionOfALineDoesNotMatter) {
  for (int i = 0; i < kScenes; ++i) {
    Interpolant f = ample(PrimitiveKind::line);
    if (i % 2 == 0) f.line_parameter = LineParameter::major_axis;
    const Point sample = inside();
    const Interval given = interpolate_exact(f, sample);
    std::swap(f.positions[0], f.positions[1]);
    std::swap(f.values[0], f.values[1]);
    std::swap(f.w[0], f.w[1]);
    const Interval turned = interpolate_exact(f, sample);
    EXPECT_TRUE(overlap(given, turned));
    EXPECT_LT(width_of(hull(given, turned)), 4 * kNarrow);
  }
}

TEST_F(InterpolationProperties, ConstantsStayConstantToTheBit) {
  const QuadPixel pixel{{5, 5}, {4, 4}};
  for (int i = 0; i < kScenes; ++i) {
    Interpolant f = ample(static_cast<PrimitiveKind>(i % 3));
    f.perspective = i % 2 == 0;
    if (i % 4 < 2) f.line_parameter = LineParameter::major_axis;
    const double value = numbers_.attribute(1e6);
    // A number, or a quotient that is none; the entry beyond the vertices is no part of it.
    const Interval constant = i % 5 == 0 ? Interval(value) / 3 : Interval(value);
    f.values = {constant, constant, constant};
    for (std::size_t k = static_cast<std::size_t>(vertices_of(f.kind)); k < 3; ++k)
      f.values[k] = value + 1;
    const Point anywhere = numbers_.point(Fixed::kOne * 4096);
    EXPECT_TRUE(same(interpolate_exact(f, anywhere), constant));
    for (const Axis axis : {Axis::x, Axis::y}) {
      EXPECT_TRUE(same(differentiate_exact(f, anywhere, axis), 0));
      for (const DerivativeMethod method : values_of<DerivativeMethod>())
        EXPECT_TRUE(same(derivative_exact(f, pixel, axis, method), 0));
    }
  }
}

TEST_F(InterpolationProperties, EqualWAreNoPerspectiveToTheBit) {
  for (int i = 0; i < kScenes; ++i) {
    Interpolant f = ample(i % 2 == 0 ? PrimitiveKind::triangle : PrimitiveKind::line);
    for (Interval& w : f.w) w = f.w[0];
    // What lies beyond the vertices of a line is no part of it.
    if (f.kind == PrimitiveKind::line) f.w[2] = 2 * f.w[0].low;
    Interpolant plain = f;
    plain.perspective = false;
    const Point sample = inside();
    EXPECT_TRUE(same(interpolate_exact(f, sample), interpolate_exact(plain, sample)));
    const Interval inexact = interpolate_inexact(f, sample);
    const Interval inexact_plain = interpolate_inexact(plain, sample);
    const Interval permitted = interpolate_permitted(f, sample, reach_of(4));
    const Interval permitted_plain = interpolate_permitted(plain, sample, reach_of(4));
    if (f.kind == PrimitiveKind::line) {
      // Equation 14.6 divides by w all the same, and each operation errs.
      EXPECT_TRUE(inexact.contains(inexact_plain.low) && inexact.contains(inexact_plain.high));
      EXPECT_TRUE(permitted.contains(permitted_plain.low) &&
                  permitted.contains(permitted_plain.high));
    } else {
      EXPECT_TRUE(same(inexact, inexact_plain));
      EXPECT_TRUE(same(permitted, permitted_plain));
    }
    EXPECT_TRUE(
        same(differentiate_exact(f, sample, Axis::x), differentiate_exact(plain, sample, Axis::x)));
  }
}

// Only the ratios of w count.
TEST_F(InterpolationProperties, AllWTwiceAsLargeChangeNothing) {
  for (int i = 0; i < kScenes; ++i) {
    Interpolant f = ample(i % 2 == 0 ? PrimitiveKind::triangle : PrimitiveKind::line);
    const Point sample = inside();
    const Interval given = interpolate_exact(f, sample);
    for (Interval& w : f.w) w = 2 * w.low;
    EXPECT_TRUE(same(interpolate_exact(f, sample), given));
  }
}

// The same quotient, from linear interpolation of attribute/w and of 1/w.
TEST_F(InterpolationProperties, PerspectiveIsAQuotientOfLinearOnes) {
  for (int i = 0; i < kScenes; ++i) {
    const Interpolant f = ample(i % 2 == 0 ? PrimitiveKind::triangle : PrimitiveKind::line);
    Interpolant divided = f;
    Interpolant inverse = f;
    divided.perspective = inverse.perspective = false;
    for (std::size_t k = 0; k < 3; ++k) {
      divided.values[k] = f.values[k] / f.w[k];
      inverse.values[k] = Interval(1) / f.w[k];
    }
    const Point sample = inside();
    const Interval below = interpolate_exact(inverse, sample);
    EXPECT_GT(below.low, 0);
    const Interval quotient = interpolate_exact(divided, sample) / below;
    const Interval value = interpolate_exact(f, sample);
    EXPECT_TRUE(overlap(quotient, value));
    // Terms of 1/w as large as 2^8 make a sum as small as 2^-8 of them.
    EXPECT_LT(width_of(hull(quotient, value)), 0x1p-35);
  }
}

TEST_F(InterpolationProperties, AtAVertexItIsTheVertexsValue) {
  for (int i = 0; i < kScenes; ++i) {
    const Interpolant f = ample(i % 2 == 0 ? PrimitiveKind::triangle : PrimitiveKind::line);
    for (std::size_t k = 0; k < static_cast<std::size_t>(vertices_of(f.kind)); ++k) {
      const Interval value = interpolate_exact(f, nearest_point(f.positions[k]));
      EXPECT_TRUE(value.contains(f.values[k].low));
      EXPECT_LT(width_of(value), kNarrow);
    }
  }
}

TEST_F(InterpolationProperties, AlongAnAxisBothParametersOfALineAreOne) {
  for (int i = 0; i < kScenes; ++i) {
    Interpolant f = ample(PrimitiveKind::line);
    if (i % 2 == 0)
      f.positions[1].x = f.positions[0].x;
    else
      f.positions[1].y = f.positions[0].y;
    if (same_point(f.positions[0], f.positions[1])) continue;
    f.perspective = i % 4 < 2;
    const Point sample = inside();
    const Interval projected = interpolate_exact(f, sample);
    f.line_parameter = LineParameter::major_axis;
    const Interval walked = interpolate_exact(f, sample);
    EXPECT_TRUE(overlap(projected, walked));
    EXPECT_EQ(is_everything(projected), is_everything(walked));
  }
}

// --------------------------------------------------------------------------------- known by hand

TEST(Perspective, HalfwayAlongALineIsNearerToTheNearEnd) {
  Interpolant f{PrimitiveKind::line, {vertex_at(0, 0), vertex_at(4, 0), {}}, {0, 1, 0}, {1, 3, 1}};
  // (0/1 + 1/3) / (1/1 + 1/3)
  EXPECT_TRUE(interpolate_exact(f, at(2, 0)).contains(0.25));
  f.perspective = false;
  EXPECT_TRUE(interpolate_exact(f, at(2, 0)).contains(0.5));
}

TEST(Perspective, ACentroidIsNearerToTheNearCorner) {
  Interpolant f{PrimitiveKind::triangle,
                {vertex_at(0, 0), vertex_at(3, 0), vertex_at(0, 3)},
                {0, 0, 1},
                {1, 1, 4}};
  // (1/4) / (1 + 1 + 1/4)
  EXPECT_TRUE(holds(interpolate_exact(f, at(1, 1)), static_cast<Wide>(1) / 9));
  f.perspective = false;
  EXPECT_TRUE(holds(interpolate_exact(f, at(1, 1)), static_cast<Wide>(1) / 3));
}

// 1/w runs out beyond the end. There nothing is known, and on the other side of it the quotient has
// the other sign.
TEST(Perspective, BeyondTheHorizon) {
  // 1/w is 1 - x/4.
  const Interpolant at_four{
      PrimitiveKind::line, {vertex_at(0, 0), vertex_at(3, 0), {}}, {1, 3, 0}, {1, 4, 1}};
  EXPECT_TRUE(is_everything(interpolate_exact(at_four, at(4, 0))));
  EXPECT_TRUE(is_everything(differentiate_exact(at_four, at(4, 0), Axis::x)));
  // (1 - x/16) / (1 - 3x/16)
  const Interpolant between{
      PrimitiveKind::line, {vertex_at(0, 0), vertex_at(4, 0), {}}, {1, 3, 0}, {1, 4, 1}};
  EXPECT_TRUE(interpolate_exact(between, at(5, 0)).contains(11));
  EXPECT_TRUE(interpolate_exact(between, at(6, 0)).contains(-5));
}

}  // namespace
}  // namespace edgecase
