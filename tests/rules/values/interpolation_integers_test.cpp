// SPDX-License-Identifier: MIT
//
// The exact side of interpolation at the ends of its integers: the smallest areas and runs, the
// largest products, and weights that cancel.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr std::int64_t kLargestW = std::int64_t{1} << 32;

Interpolant line_of(HomogeneousPoint a, HomogeneousPoint b) {
  Interpolant f;
  f.kind = PrimitiveKind::line;
  f.positions = {a, b, {}};
  f.values = {0, 1, 0};
  return f;
}

void expect_near(Interval interval, double value, double error) {
  EXPECT_TRUE(interval.low <= value && value <= interval.high) << interval.low << " " << value;
  EXPECT_LE(width_of(interval), error);
}

// Vertices with w = 1 are whole pixels: no area but 0 is smaller.
TEST(InterpolationIntegers, TheUnitTriangleEitherWay) {
  Interpolant f;
  f.positions = {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  f.values = {1, 2, 4};
  expect_near(interpolate_exact(f, at(0.25, 0.5)), 2.75, 1e-13);
  expect_near(differentiate_exact(f, at(0.25, 0.5), Axis::x), 1, 1e-13);
  std::swap(f.positions[1], f.positions[2]);
  std::swap(f.values[1], f.values[2]);
  expect_near(interpolate_exact(f, at(0.25, 0.5)), 2.75, 1e-13);
  expect_near(differentiate_exact(f, at(0.25, 0.5), Axis::y), 3, 1e-13);
}

TEST(InterpolationIntegers, TheUnitLineByItsMajorAxisEitherWay) {
  Interpolant f = line_of({0, 0, 1}, {1, 0, 1});
  f.line_parameter = LineParameter::major_axis;
  expect_near(interpolate_exact(f, at(0.25, 0.5)), 0.25, 1e-14);
  f = line_of({1, 0, 1}, {0, 0, 1});
  f.line_parameter = LineParameter::major_axis;
  expect_near(interpolate_exact(f, at(0.25, 0.5)), 0.75, 1e-14);
}

// A line's third vertex is not looked at: not where the two others lie on a line with it, nor where
// one of them lies on it.
TEST(InterpolationIntegers, LinesThroughTheOrigin) {
  expect_near(interpolate_exact(line_of(vertex_at(1, 1), vertex_at(3, 3)), at(2, 2)), 0.5, 1e-14);
  expect_near(interpolate_exact(line_of(vertex_at(0, 0), vertex_at(4, 0)), at(1, 0)), 0.25, 1e-14);
}

TEST(InterpolationIntegers, WithoutAreaNothingIsKnownWhateverW) {
  Interpolant f;
  f.positions = {vertex_at(0, 0), vertex_at(4, 4), vertex_at(8, 8)};
  f.values = {1, 2, 4};
  f.w = {1, 2, 4};
  EXPECT_TRUE(is_everything(interpolate_exact(f, at(3, 2))));
  EXPECT_TRUE(is_everything(differentiate_exact(f, at(3, 2), Axis::x)));
}

TEST(InterpolationIntegers, WhatDiffersAtOneEndIsNotConstant) {
  Interpolant f = line_of(vertex_at(0, 0), vertex_at(4, 0));
  f.values = {Interval(0, 1), Interval(0, 2), 0};
  EXPECT_GT(interpolate_exact(f, at(4, 0)).high, 1.9);
  f.values = {Interval(0, 1), Interval(-1, 1), 0};
  EXPECT_LT(interpolate_exact(f, at(4, 0)).low, -0.9);
}

// The sample lies across from the first vertex: the two products of its weight cancel to nothing.
TEST(InterpolationIntegers, WeightsThatCancelAreZero) {
  const Interpolant f = line_of(vertex_at(10.25, 3.5), vertex_at(13.5, 5.75));
  const Interval across = interpolate_exact(f, at(10.25 - 2.25, 3.5 + 3.25));
  EXPECT_LT(across.magnitude(), 1e-300);
}

// Differences of such vertices take up to 79 bits, and products of two of them more than 127.
TEST(InterpolationIntegers, ProductsBeyondTheWidestInteger) {
  const auto far = [](std::int64_t x, std::int64_t y) {
    return HomogeneousPoint{x * kLargestW, y * kLargestW, kLargestW};
  };
  expect_near(interpolate_exact(line_of(far(0, 1), far(8000, 1)), at(2000, 1)), 0.25, 1e-13);
  expect_near(interpolate_exact(line_of(far(1, 0), far(1, 8000)), at(1, 6000)), 0.75, 1e-13);
  expect_near(interpolate_exact(line_of(far(0, 0), far(8000, 4000)), at(1000, 3000)), 0.25, 1e-13);
  expect_near(interpolate_exact(line_of(far(0, 4000), far(8000, 0)), at(2000, 3000)), 0.25, 1e-13);
}

}  // namespace
}  // namespace edgecase
