// SPDX-License-Identifier: MIT
#include "rules/output/polygon_offset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "exact/rational.h"
#include "rules/values/framebuffer.h"
#include "tests/oracles/attribute_planes.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kReach = 1.0 / 256;
constexpr Interval kUnits{0x1p-24, 0x1p-23};  // one and two steps of 24 bits
constexpr DepthFormat kFormats[] = {DepthFormat::depth16, DepthFormat::depth24,
                                    DepthFormat::depth32f};

// Its gradient is (3/256, -4/256).
Interpolant known_plane() {
  Interpolant f;
  f.positions = {vertex_at(2, 20), vertex_at(18, 20), vertex_at(2, 4)};
  f.values = {0.25, 0.25 + 3.0 / 16, 0.25 + 4.0 / 16};
  return f;
}

// Depth runs linearly in the window whatever w is.
Interpolant in_perspective(Interpolant f) {
  f.w = {1, 3, 0.5};
  f.perspective = true;
  return f;
}

void expect_about(Interval value, double expected) {
  EXPECT_TRUE(value.contains(expected)) << value.low << " " << value.high << " " << expected;
  EXPECT_LE(width_of(value), std::fabs(expected) * 1e-13 + 1e-300) << expected;
}

Interval offset_by(const PolygonOffset& offset, OffsetChoice choice = {},
                   DepthFormat format = DepthFormat::depth24) {
  return offset_exact(offset, known_plane(), format, choice);
}

TEST(PolygonOffset, TheFactorMultipliesTheSlope) {
  const PolygonOffset twice{2, 0, 0};
  for (const DepthFormat format : kFormats) {
    expect_about(offset_by(twice, {}, format), 10.0 / 256);
    expect_about(offset_by({-1, 0, 0}, {}, format), -5.0 / 256);
    expect_about(offset_by(twice, {.slope = OffsetSlope::largest_partial}, format), 8.0 / 256);
    expect_about(offset_by(twice, {.slope = OffsetSlope::sum_of_partials}, format), 14.0 / 256);
    expect_about(offset_by(twice, {.slope = OffsetSlope::ignored}, format), 0);
  }
  expect_about(offset_exact(twice, in_perspective(known_plane()), DepthFormat::depth24, {}),
               10.0 / 256);
}

TEST(PolygonOffset, UnitsMultiplyAStepOfAFixedPointBuffer) {
  const PolygonOffset three{0, 3, 0};
  const auto by = [&](OffsetUnit unit, DepthFormat format) {
    return offset_by(three, {.unit = unit}, format);
  };
  for (const auto& [format, bits] :
       {std::pair{DepthFormat::depth16, 16}, std::pair{DepthFormat::depth24, 24}}) {
    const double values = std::ldexp(1, bits);
    expect_about(by(OffsetUnit::step, format), 3 / (values - 1));
    expect_about(by(OffsetUnit::power, format), 3 / values);
    expect_about(by(OffsetUnit::two_steps, format), 6 / (values - 1));
    expect_about(by(OffsetUnit::four_steps, format), 12 / (values - 1));
    expect_about(by(OffsetUnit::half_step, format), 1.5 / (values - 1));
    expect_about(by(OffsetUnit::of_24_bits, format), 0x3p-24);
    expect_about(by(OffsetUnit::ignored, format), 0);
    // A step is what moves a stored value to the next.
    const double stored = 1000 / (values - 1);
    const double step = by(OffsetUnit::step, format).low / 3;
    EXPECT_EQ(to_depth(stored + step, format), 1001 / (values - 1));
    EXPECT_EQ(to_depth(stored + 0.49 * step, format), stored);
  }
  EXPECT_GT(by(OffsetUnit::step, DepthFormat::depth16).low,
            by(OffsetUnit::power, DepthFormat::depth16).high);
}

TEST(PolygonOffset, UnitsOfAFloatBufferFollowTheLargestDepth) {
  const PolygonOffset unit_alone{0, 1, 0};
  const auto by = [&](double largest, OffsetExponent exponent, OffsetUnit unit = OffsetUnit::step) {
    Interpolant f = known_plane();
    f.values = {largest / 2, largest, 0};
    return offset_exact(unit_alone, f, DepthFormat::depth32f, {.unit = unit, .exponent = exponent});
  };
  using enum OffsetExponent;
  expect_about(by(1, largest_depth), 0x1p-23);
  expect_about(by(0.75, largest_depth), 0x1p-24);
  expect_about(by(0.5, largest_depth), 0x1p-24);
  expect_about(by(0.4375, largest_depth), 0x1p-25);
  // As float32 it is 1.
  expect_about(by(1 - 0x1p-30, largest_depth), 0x1p-23);
  expect_about(by(0, largest_depth), 0x1p-149);
  expect_about(by(0x1p-130, largest_depth), 0x1p-149);
  expect_about(by(0x1p-126, largest_depth), 0x1p-149);
  expect_about(by(0x1p-125, largest_depth), 0x1p-148);
  expect_about(by(0.4375, doubled), 0x1p-24);
  expect_about(by(0.4375, halved), 0x1p-26);
  expect_about(by(0.4375, OffsetExponent::one), 0x1p-23);
  expect_about(by(0.4375, as_fixed), 1 / (0x1p24 - 1));
  expect_about(by(0.4375, as_fixed, OffsetUnit::two_steps), 2 / (0x1p24 - 1));
  // The unit of a fixed-point buffer is none of a float's.
  expect_about(by(0.4375, largest_depth, OffsetUnit::two_steps), 0x1p-25);
}

// Its ends may round to two numbers of different exponents.
TEST(PolygonOffset, AnUncertainDepthHasTheUnitsOfBoth) {
  Interpolant f = known_plane();
  f.values = {0.25, Interval(0.5 - 0x1p-20, 0.5 + 0x1p-20), 0.125};
  const Interval units = offset_exact({0, 1, 0}, f, DepthFormat::depth32f, {});
  EXPECT_TRUE(units.contains(0x1p-25));
  EXPECT_TRUE(units.contains(0x1p-24));
  // A quotient that is a power of two, rounded outwards, has one.
  f.values[1] = outward(0.5, 0.5);
  expect_about(offset_exact({0, 1, 0}, f, DepthFormat::depth32f, {}), 0x1p-24);
}

TEST(PolygonOffset, TheClampIsTheFarthest) {
  // Without it 5/256.
  expect_about(offset_by({1, 0, 0.25F}), 5.0 / 256);
  expect_about(offset_by({1, 0, 0.015625F}), 0.015625);
  expect_about(offset_by({1, 0, -0.015625F}), 5.0 / 256);
  expect_about(offset_by({-1, 0, 0.015625F}), -5.0 / 256);
  expect_about(offset_by({-1, 0, -0.015625F}), -0.015625);
  expect_about(offset_by({-1, 0, -0.25F}), -5.0 / 256);
  const Interval permitted =
      offset_permitted({1, 0, 0.015625F}, known_plane(), DepthFormat::depth24, kReach, kUnits);
  EXPECT_EQ(permitted.high, 0.015625);
}

TEST(PolygonOffset, OnlyTrianglesOfAnAreaHaveOne) {
  const PolygonOffset offset{1, 1, 0};
  for (const PrimitiveKind kind : {PrimitiveKind::point, PrimitiveKind::line}) {
    Interpolant f = known_plane();
    f.kind = kind;
    EXPECT_EQ(offset_exact(offset, f, DepthFormat::depth24, {}).magnitude(), 0);
    EXPECT_EQ(offset_permitted(offset, f, DepthFormat::depth24, kReach, kUnits).magnitude(), 0);
  }
  Interpolant f = known_plane();
  f.positions[2] = f.positions[1];
  EXPECT_EQ(offset_exact(offset, f, DepthFormat::depth24, {}).magnitude(), 0);
  EXPECT_TRUE(is_everything(offset_permitted(offset, f, DepthFormat::depth24, kReach, kUnits)));
  // Without a buffer there are no units.
  expect_about(offset_exact({0, 9, 0}, known_plane(), DepthFormat::none, {}), 0);
}

// ------------------------------------------------------------------------------- random planes

class OffsetPlanes : public ::testing::Test {
 protected:
  // Legs of 16 pixels or more, so that no slope is steep.
  Interpolant triangle() {
    Interpolant f;
    const double x = numbers_.real(8, 10), y = numbers_.real(8, 10);
    const auto corner = [&](double dx, double dy) {
      return vertex_at(std::floor(256 * (x + dx + numbers_.real(0, 4))) / 256,
                       std::floor(256 * (y + dy + numbers_.real(0, 4))) / 256);
    };
    f.positions = {corner(0, 0), corner(20, 0), corner(0, 20)};
    if (numbers_.one_in(2)) std::swap(f.positions[1], f.positions[2]);
    for (Interval& value : f.values) value = std::fabs(numbers_.attribute(1));
    f.perspective = false;
    return f;
  }
  // Of a quotient by a w of its own.
  Interpolant homogeneous_triangle() {
    Interpolant f = triangle();
    for (HomogeneousPoint& p : f.positions) {
      const std::int64_t w = numbers_.integer(1, 1000);
      p = {p.x * w / Fixed::kOne + 1, p.y * w / Fixed::kOne, w};
    }
    return f;
  }
  Interpolant moved(Interpolant f) {
    for (HomogeneousPoint& p : f.positions) {
      p.x += numbers_.integer(-1, 1) * (Fixed::kOne / 256 - 1);
      p.y += numbers_.integer(-1, 1) * (Fixed::kOne / 256 - 1);
    }
    return f;
  }

  RandomNumbers numbers_{38};
};

struct Slopes {
  Rational x;
  Rational y;
  Rational largest() const { return std::max(abs(x), abs(y)); }
  Rational squared_length() const { return x * x + y * y; }
};

Slopes slopes_of(const Interpolant& f) {
  ProjectedTriangle<Rational> v;
  for (std::size_t i = 0; i < 3; ++i) {
    v.x[i] = Rational(f.positions[i].x, f.positions[i].w);
    v.y[i] = Rational(f.positions[i].y, f.positions[i].w);
    v.w[i] = 1;
    v.values[i] = rational_of(f.values[i].low);
  }
  const AttributePlanes<Rational> planes(v);
  return {planes.slope_x(0, 0), planes.slope_y(0, 0)};
}

bool contains(Interval interval, const Rational& value) {
  return rational_of(interval.low) <= value && value <= rational_of(interval.high);
}

// Of a number of which the square is known, 0 or more.
bool contains_root(Interval interval, const Rational& square) {
  const Rational low = rational_of(std::max(interval.low, 0.0));
  const Rational high = rational_of(interval.high);
  return low * low <= square && square <= high * high;
}

TEST_F(OffsetPlanes, SlopesAreThoseOfThePlane) {
  for (int i = 0; i < 2000; ++i) {
    const Interpolant f = i % 2 == 0 ? triangle() : homogeneous_triangle();
    const Slopes slopes = slopes_of(f);
    const Interval length = offset_exact({1, 0, 0}, f, DepthFormat::depth24, {});
    const Interval largest =
        offset_exact({1, 0, 0}, f, DepthFormat::depth24, {.slope = OffsetSlope::largest_partial});
    ASSERT_TRUE(contains_root(length, slopes.squared_length()));
    ASSERT_TRUE(contains(largest, slopes.largest()));
    ASSERT_LT(width_of(length), 1e-13);
    ASSERT_LT(width_of(largest), 1e-13);
  }
}

// The slope is made of products of depths, of at most 1, and edges, of less than 32 pixels, over
// the area.
TEST_F(OffsetPlanes, SlopesOfSliversStayNarrow) {
  for (int i = 0; i < 1000; ++i) {
    Interpolant f = triangle();
    // Steps of 2^-16 pixel beside the line through the other two.
    f.positions[2] = f.positions[1];
    f.positions[2].x -= numbers_.integer(1, 3);
    f.positions[2].y += numbers_.integer(1, 3);
    const auto& v = f.positions;
    const double area = static_cast<double>(cross(v[0], v[1], v[2])) * 0x1p-48;
    const Slopes slopes = slopes_of(f);
    const Interval length = offset_exact({1, 0, 0}, f, DepthFormat::depth24, {});
    ASSERT_TRUE(contains_root(length, slopes.squared_length()));
    ASSERT_LT(width_of(length), 64 * 0x1p-52 * 32 / area);
  }
}

TEST_F(OffsetPlanes, PermittedHoldsEveryOpenAlternativeOfMovedVertices) {
  for (int i = 0; i < 2000; ++i) {
    const Interpolant f = triangle();
    const auto factor = static_cast<float>(numbers_.integer(-4, 4));
    const auto units = static_cast<float>(numbers_.integer(-8, 8));
    const float clamp = numbers_.one_in(3) ? static_cast<float>(numbers_.real(-0.01, 0.01)) : 0;
    const PolygonOffset offset{factor, units, clamp};
    for (const DepthFormat format : kFormats) {
      const Interval permitted =
          offset_permitted(offset, f, format, kReach, permitted_fixed_unit(format));
      const Interpolant g = moved(f);
      for (const OffsetSlope slope : {OffsetSlope::length, OffsetSlope::largest_partial})
        for (const OffsetUnit unit :
             {OffsetUnit::step, OffsetUnit::power, OffsetUnit::two_steps, OffsetUnit::four_steps})
          ASSERT_TRUE(holds(permitted, offset_exact(offset, g, format, {slope, unit, {}})))
              << name_of(format) << " " << name_of(slope) << " " << name_of(unit);
    }
  }
}

// The errors of a slope: its operations', and what moves of two steps in 16 pixels do to it.
TEST_F(OffsetPlanes, PermittedIsNotMuchWider) {
  for (int i = 0; i < 2000; ++i) {
    const Interpolant f = triangle();
    const Slopes slopes = slopes_of(f);
    const double length = std::sqrt(static_cast<double>(slopes.squared_length()));
    const auto largest = static_cast<double>(slopes.largest());
    const Interval still = offset_permitted({1, 0, 0}, f, DepthFormat::depth24, 0, kUnits);
    EXPECT_LE(still.high - length, 3e-4 * 0.1);
    EXPECT_LE(largest - still.low, 3e-4 * 0.1);
    const Interval moved = offset_permitted({1, 0, 0}, f, DepthFormat::depth24, kReach, kUnits);
    EXPECT_LE(moved.high - length, 3e-4);
    EXPECT_LE(largest - moved.low, 3e-4);
  }
}

// From 2^-n on, and of 1 at most.
TEST(PolygonOffset, TheUnitOfAFixedPointBufferHasNoOtherBound) {
  for (const auto& [format, least] :
       {std::pair{DepthFormat::depth16, 0x1p-16}, std::pair{DepthFormat::depth24, 0x1p-24}}) {
    EXPECT_EQ(permitted_fixed_unit(format).low, least);
    EXPECT_EQ(permitted_fixed_unit(format).high, 1);
  }
}

// Its two operations err by 1 part in 10^5 of the larger end.
TEST(PolygonOffset, PermittedUnitsAreThoseGivenOfFixedPointBuffersAlone) {
  const Interpolant f = known_plane();
  const auto expect_units = [&](DepthFormat format, double low, double high) {
    const Interval given = format == DepthFormat::depth32f ? Interval(7) : Interval(low, high);
    const Interval units = offset_permitted({0, 1, 0}, f, format, kReach, given);
    EXPECT_NEAR(units.low, low - 2e-5 * high, 1e-9 * high);
    EXPECT_NEAR(units.high, high + 2e-5 * high, 1e-9 * high);
    return units;
  };
  const Interval of_16 = expect_units(DepthFormat::depth16, 0x1p-16, 2 / (0x1p16 - 1) + 0x1p-23);
  expect_units(DepthFormat::depth24, 0x1p-24, 2 / (0x1p24 - 1) + 0x1p-23);
  // A step of 24 bits is no unit of a buffer of 16.
  EXPECT_LT(0x1p-24, of_16.low);
  // Depths of at most a half: just below it, or it.
  expect_units(DepthFormat::depth32f, 0x1p-25, 0x1p-24);
}

TEST(PolygonOffset, NothingIsKnownOfTheSlopeOfASliver) {
  Interpolant f = known_plane();
  f.positions[2] = vertex_at(10, 20.001953125);
  EXPECT_TRUE(is_everything(offset_permitted({1, 0, 0}, f, DepthFormat::depth24, kReach, kUnits)));
  // Units alone do not depend on it.
  EXPECT_LT(offset_permitted({0, 1, 0}, f, DepthFormat::depth24, kReach, kUnits).high, 0x1p-21);
}

}  // namespace
}  // namespace edgecase
