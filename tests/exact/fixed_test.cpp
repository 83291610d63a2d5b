// SPDX-License-Identifier: MIT
//
// Fixed against wider integers, near zero and at the corners of the coordinate range. Built with
// the sanitizers, the same tests show that nothing overflows there.
#include "exact/fixed.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace edgecase {
namespace {

constexpr std::int64_t kEnd = Fixed::kMaxCoordinate * Fixed::kOne;

// The largest multiple of 2^16 not above raw, by search and not by shifting.
std::int64_t literal_floor(std::int64_t raw) {
  std::int64_t whole = raw / Fixed::kOne;
  while (whole * Fixed::kOne > raw) --whole;
  return whole;
}

TEST(Fixed, FloorAndCeilEncloseTheNumberTightly) {
  for (std::int64_t around : {std::int64_t{0}, Fixed::kOne, -Fixed::kOne, kEnd, -kEnd})
    for (std::int64_t raw = around - 70000; raw <= around + 70000; raw += 1) {
      const Fixed value = Fixed::from_raw(raw);
      ASSERT_EQ(value.floor(), literal_floor(raw)) << raw;
      ASSERT_EQ(value.ceil(), -literal_floor(-raw)) << raw;
    }
}

TEST(Fixed, WholeNumbersAreTheirOwnFloorAndCeil) {
  for (std::int64_t whole = -Fixed::kMaxCoordinate; whole <= Fixed::kMaxCoordinate; ++whole) {
    const Fixed value = Fixed::from_integer(whole);
    ASSERT_EQ(value.floor(), whole);
    ASSERT_EQ(value.ceil(), whole);
    ASSERT_EQ(Fixed::centre_of(whole).floor(), whole);
    ASSERT_EQ(Fixed::centre_of(whole).ceil(), whole + 1);
  }
}

TEST(Fixed, TheRangeIncludesItsEnds) {
  EXPECT_TRUE(Fixed::from_raw(kEnd).in_coordinate_range());
  EXPECT_TRUE(Fixed::from_raw(-kEnd).in_coordinate_range());
  EXPECT_FALSE(Fixed::from_raw(kEnd + 1).in_coordinate_range());
  EXPECT_FALSE(Fixed::from_raw(-kEnd - 1).in_coordinate_range());
}

TEST(Fixed, ArithmeticAndOrderAreThoseOfTheRawNumbers) {
  const Fixed a = Fixed::from_raw(3);
  const Fixed b = Fixed::from_raw(-5);
  EXPECT_EQ((a + b).raw(), -2);
  EXPECT_EQ((a - b).raw(), 8);
  EXPECT_EQ((-a).raw(), -3);
  EXPECT_LT(b, a);
  EXPECT_EQ(Fixed::from_integer(7), Fixed::from_raw(7 * 65536));
  EXPECT_EQ(Fixed(), Fixed::from_raw(0));
}

TEST(Fixed, DoublesHoldEveryCoordinateExactly) {
  for (std::int64_t raw : {kEnd, -kEnd, kEnd - 1, 1 - kEnd, std::int64_t{1}, std::int64_t{-1}})
    EXPECT_EQ(static_cast<std::int64_t>(std::ldexp(Fixed::from_raw(raw).to_double(), 16)), raw);
}

TEST(PixelCentre, LiesHalfAPixelFromItsCorners) {
  const Point centre = pixel_centre(2, -3);
  EXPECT_EQ(centre.x, Fixed::from_raw(5 * Fixed::kOne / 2));
  EXPECT_EQ(centre.y, Fixed::from_raw(-5 * Fixed::kOne / 2));
}

Int128 wide_cross(Point a, Point b, Point p) {
  return (static_cast<Int128>(b.x.raw()) - a.x.raw()) * (p.y.raw() - a.y.raw()) -
         (static_cast<Int128>(b.y.raw()) - a.y.raw()) * (p.x.raw() - a.x.raw());
}

TEST(Cross, AtEveryCornerOfTheRangeItEqualsTheWideProduct) {
  std::array<Point, 9> places;
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = {Fixed::from_raw((static_cast<std::int64_t>(i) % 3 - 1) * kEnd),
                 Fixed::from_raw((static_cast<std::int64_t>(i) / 3 - 1) * kEnd)};
  for (Point a : places)
    for (Point b : places)
      for (Point p : places) ASSERT_TRUE(cross(a, b, p) == wide_cross(a, b, p));
}

TEST(Cross, OfRandomPointsItEqualsTheWideProduct) {
  std::mt19937_64 engine(1);
  std::uniform_int_distribution<std::int64_t> raw(-kEnd, kEnd);
  const auto point = [&] {
    return Point{Fixed::from_raw(raw(engine)), Fixed::from_raw(raw(engine))};
  };
  for (int i = 0; i < 100000; ++i) {
    const Point a = point(), b = point(), p = point();
    ASSERT_TRUE(cross(a, b, p) == wide_cross(a, b, p));
    ASSERT_EQ(cross(a, b, p), -cross(b, a, p));
  }
}

TEST(Cross, IsPositiveToTheLeftWithYUp) {
  const Point origin{}, right = pixel_centre(4, 0), up = pixel_centre(0, 4);
  EXPECT_GT(cross(origin, right, up), 0);
  EXPECT_LT(cross(origin, up, right), 0);
  EXPECT_EQ(cross(origin, up, up), 0);
}

}  // namespace
}  // namespace edgecase
