// SPDX-License-Identifier: MIT
#include "casefile/mesh/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace edgecase {
namespace {

Fixed f(double value) {
  return Fixed::from_raw(static_cast<std::int64_t>(std::ldexp(value, 16)));
}

AffineStep step(double a, double b, double c, double d, double e = 0, double shift = 0) {
  return affine_step({f(a), f(b), f(c), f(d), f(e), f(shift)});
}

MovedPoint moved(Point point, const std::vector<AffineStep>& steps) {
  const auto result = move_point(point, steps);
  EXPECT_TRUE(result.has_value());
  return result.value_or(MovedPoint{});
}

TEST(Affine, AppliesTheFirstStepFirst) {
  const Point point{f(3), f(1)};
  const AffineStep shift = step(1, 0, 0, 1, 2, -1);
  const AffineStep scale = step(2, 0, 0, 0.5);
  EXPECT_EQ(moved(point, {shift, scale}).point, (Point{f(10), f(0)}));
  EXPECT_EQ(moved(point, {scale, shift}).point, (Point{f(8), f(-0.5)}));
  EXPECT_EQ(moved(point, {step(1, 3, 2, 1)}).point, (Point{f(5), f(10)}));
}

TEST(Affine, QuarterTurnsAreExact) {
  const Point point{f(3), Fixed::from_raw(1)};
  const Point minus{-point.x, -point.y};
  const Point images[] = {point, {minus.y, point.x}, minus, {point.y, minus.x}};
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const MovedPoint turned = moved(point, {turn_step(Fixed::from_integer(90 * quarter))});
    EXPECT_EQ(turned.point, images[(quarter + 8) % 4]) << quarter;
    EXPECT_TRUE(turned.exact);
  }
  EXPECT_FALSE(moved(point, {turn_step(f(45))}).exact);
}

TEST(Affine, SaysWhetherAnythingWasRounded) {
  const Point fine{Fixed::from_raw(3), f(1)};
  EXPECT_TRUE(moved(fine, {step(4, 0, 0, 1)}).exact);
  const MovedPoint half = moved(fine, {step(0.5, 0, 0, 1)});
  EXPECT_FALSE(half.exact);
  EXPECT_EQ(half.point.x.raw(), 2);
  // What is too fine for a coordinate on the way may be exact in the end.
  EXPECT_TRUE(moved(fine, {step(0.5, 0, 0, 1), step(2, 0, 0, 1)}).exact);
  EXPECT_EQ(moved(fine, {step(0.5, 0, 0, 1), step(2, 0, 0, 1)}).point, fine);
}

TEST(Affine, RefusesWhatLeavesTheRange) {
  const Point point{f(100), f(1)};
  const std::vector<AffineStep> steps{step(200, 0, 0, 1), step(0.0078125, 0, 0, 1)};
  EXPECT_FALSE(move_point(point, steps).has_value());
}

// Against doubles, which hold these numbers with 30 bits to spare.
TEST(Affine, AgreesWithDoubles) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int64_t> raw(-200 * 65536, 200 * 65536);
  std::uniform_int_distribution<std::int64_t> factor(-2 * 65536, 2 * 65536);
  for (int round = 0; round < 20000; ++round) {
    const Point point{Fixed::from_raw(raw(random)), Fixed::from_raw(raw(random))};
    std::array<Fixed, 6> numbers;
    for (Fixed& number : numbers) number = Fixed::from_raw(factor(random));
    const Fixed degrees = Fixed::from_raw(raw(random));
    const double angle = degrees.to_double() * std::numbers::pi / 180;
    const auto [a, b, c, d, e, shift] = numbers;
    double x = point.x.to_double() * std::cos(angle) - point.y.to_double() * std::sin(angle);
    double y = point.x.to_double() * std::sin(angle) + point.y.to_double() * std::cos(angle);
    const double next_x = a.to_double() * x + c.to_double() * y + e.to_double();
    const double next_y = b.to_double() * x + d.to_double() * y + shift.to_double();
    const MovedPoint result = moved(point, {turn_step(degrees), affine_step(numbers)});
    EXPECT_LE(std::abs(result.point.x.to_double() - next_x), std::ldexp(1.0001, -17));
    EXPECT_LE(std::abs(result.point.y.to_double() - next_y), std::ldexp(1.0001, -17));
  }
}

}  // namespace
}  // namespace edgecase
