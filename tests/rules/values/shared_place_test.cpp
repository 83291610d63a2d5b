// SPDX-License-Identifier: MIT
//
// What attributes of one primitive share at a place is what each works out by itself, to the bit,
// in whatever order they are asked for.
#include <gtest/gtest.h>

#include <array>

#include "rules/values/coordinate_pairs.h"
#include "rules/values/derivative.h"
#include "rules/values/exact_interpolation.h"
#include "rules/values/inexact_interpolation.h"
#include "rules/values/interpolation.h"
#include "rules/values/permitted_interpolation.h"
#include "rules/values/rational_interpolation.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

::testing::AssertionResult same(Interval a, Interval b) {
  if (a.low == b.low && a.high == b.high) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << a.low << " to " << a.high << " is not " << b.low << " to " << b.high;
}

// Two attributes with perspective, one without, one that is the same everywhere. Every fifth
// primitive has no extent, every other one w that differ.
using Attributes = std::array<Interpolant, 4>;

Attributes random_attributes(RandomNumbers& numbers, PrimitiveKind kind, int round) {
  Attributes f;
  for (std::size_t i = 0; i < 3; ++i) {
    HomogeneousPoint position{256 * numbers.integer(0, 32 * 256),
                              256 * numbers.integer(0, 32 * 256), Fixed::kOne};
    if (round % 5 == 0 && i > 0) position = f[0].positions[0];
    const Interval w = round % 2 == 0 ? numbers.clip_w(2) : Interval(1);
    for (Interpolant& one : f) {
      one.kind = kind;
      one.positions[i] = position;
      one.values[i] = numbers.attribute(1);
      one.w[i] = w;
      one.line_parameter = round % 3 == 0 ? LineParameter::major_axis : LineParameter::projection;
    }
  }
  f[2].perspective = false;
  f[3].values.fill(f[3].values[0]);
  return f;
}

constexpr PrimitiveKind kKinds[] = {PrimitiveKind::triangle, PrimitiveKind::line,
                                    PrimitiveKind::point};

TEST(SharedPlace, AttributesAreAsTheyAreByThemselves) {
  RandomNumbers numbers(41);
  int perspective = 0;
  for (int round = 0; round < 600; ++round)
    for (const PrimitiveKind kind : kKinds) {
      const Attributes f = random_attributes(numbers, kind, round);
      const Point sample = at(static_cast<double>(numbers.integer(0, 31)) + 0.5, 9.25);
      const ExactPlace exact(sample);
      const InexactPlace inexact(sample);
      for (std::size_t turn = 0; turn < f.size(); ++turn) {
        const Interpolant& one = f[(turn + static_cast<std::size_t>(round)) % f.size()];
        ASSERT_TRUE(same(exact.value(one), interpolate_exact(one, sample))) << round;
        ASSERT_TRUE(same(inexact.value(one), interpolate_inexact(one, sample))) << round;
        perspective += has_perspective(one) ? 1 : 0;
      }
    }
  EXPECT_GT(perspective, 600);
}

// Of every length, and for numbers that only a quotient of integers decides: values of either sign
// that cancel at a pixel's centre, and positions at quotients whose determinants exceed 64 bits.
TEST(SharedPlace, RunsOfPixelsAreAsEachPixelIsByItself) {
  RandomNumbers numbers(43);
  int decided = 0, wide = 0;
  for (int round = 0; round < 600; ++round)
    for (const PrimitiveKind kind : kKinds) {
      Attributes f = random_attributes(numbers, kind, round);
      const PixelPosition first{static_cast<int>(numbers.integer(-2, 20)),
                                static_cast<int>(numbers.integer(0, 31))};
      if (round % 3 == 0)
        for (Interpolant& one : f) {
          one.positions[0] = homogeneous(pixel_centre(first.x, first.y));
          one.positions[1] = homogeneous(pixel_centre(first.x + 8, first.y));
          one.values = {-1, 1, 0.5};
          one.w = {1, 1, 1};
        }
      if (round % 4 == 1)
        for (Interpolant& one : f)
          for (HomogeneousPoint& p : one.positions)
            p = {p.x * 8191, p.y * 8191, p.w * 8190 + (round % 8)};
      wide += round % 4 == 1;
      const auto count = static_cast<std::size_t>(numbers.integer(1, ExactRun::kLongest));
      ExactRun run(first, count);
      for (std::size_t turn = 0; turn < f.size(); ++turn) {
        const Interpolant& one = f[(turn + static_cast<std::size_t>(round)) % f.size()];
        LazyRational rational;
        std::array<Interval, ExactRun::kLongest> values;
        run.values(one, rational, values);
        for (std::size_t i = 0; i < count; ++i) {
          const Point centre = pixel_centre(first.x + static_cast<int>(i), first.y);
          const Interval alone = interpolate_exact(one, centre);
          ASSERT_TRUE(same(values[i], alone)) << round << " " << i;
          decided += kind == PrimitiveKind::triangle && alone.low == 0 && alone.high == 0;
        }
      }
    }
  EXPECT_GT(decided, 100);
  EXPECT_GT(wide, 100);
}

TEST(SharedPlace, DerivativesOfCoordinatesAreAsTheyAreByThemselves) {
  RandomNumbers numbers(42);
  ExactCoordinates exact_kept(32);
  InexactCoordinates kept(32);
  int primitive = 0;
  for (int round = 0; round < 200; ++round) {
    // The same of all kinds: what is kept of one is not taken for another's.
    const PixelPosition pixel{static_cast<int>(numbers.integer(0, 31)),
                              static_cast<int>(numbers.integer(0, 31))};
    const QuadPixel quad = in_quad(pixel, RowOrder::bottom_up, 32);
    for (const PrimitiveKind kind : kKinds) {
      const Attributes f = random_attributes(numbers, kind, round);
      ++primitive;
      // Also with one that does not move.
      const Interpolant& t = f[round % 4 == 3 ? 3 : 1];
      for (const DerivativeMethod method : values_of<DerivativeMethod>())
        for (const Axis axis : {Axis::x, Axis::y}) {
          const auto exact = exact_kept.derivatives(primitive, f[0], t, quad, axis, method);
          ASSERT_TRUE(same(exact[0], derivative_exact(f[0], quad, axis, method)));
          ASSERT_TRUE(same(exact[1], derivative_exact(t, quad, axis, method)));
          const auto inexact = kept.derivatives(primitive, f[0], t, quad, axis, method);
          ASSERT_TRUE(same(inexact[0], derivative_inexact(f[0], quad, axis, method)));
          ASSERT_TRUE(same(inexact[1], derivative_inexact(t, quad, axis, method)));
        }
      const auto values = exact_kept.at(primitive, f[0], t, pixel);
      ASSERT_TRUE(same(values[0], interpolate_exact(f[0], pixel_centre(pixel.x, pixel.y))));
      ASSERT_TRUE(same(values[1], interpolate_exact(t, pixel_centre(pixel.x, pixel.y))));
    }
  }
}

// Of a target that is wider than what is kept of a row, and at its corner, where neighbours lie
// outside.
TEST(SharedPlace, WhatIsKeptIsThatPixels) {
  RandomNumbers numbers(43);
  const Attributes f = random_attributes(numbers, PrimitiveKind::triangle, 0);
  InexactCoordinates kept(8192);
  for (int round = 0; round < 3; ++round)
    for (const int x : {0, 1, 4095, 4096, 4097, 8191})
      for (const int y : {0, 1, 3, 4, 5}) {
        const QuadPixel quad = in_quad({x, y}, RowOrder::bottom_up, 8);
        for (const DerivativeMethod method : values_of<DerivativeMethod>())
          ASSERT_TRUE(same(kept.derivatives(0, f[0], f[1], quad, Axis::x, method)[1],
                           derivative_inexact(f[1], quad, Axis::x, method)));
      }
}

}  // namespace
}  // namespace edgecase
