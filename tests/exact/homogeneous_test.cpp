// SPDX-License-Identifier: MIT
#include "exact/homogeneous.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace edgecase {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;

constexpr std::int64_t kLargestW = std::int64_t{1} << 32;

cpp_rational turn(const HomogeneousPoint& a, const HomogeneousPoint& b, const HomogeneousPoint& p) {
  const auto x = [](const HomogeneousPoint& q) { return cpp_rational(q.x) / q.w; };
  const auto y = [](const HomogeneousPoint& q) { return cpp_rational(q.y) / q.w; };
  return (x(b) - x(a)) * (y(p) - y(a)) - (y(b) - y(a)) * (x(p) - x(a));
}

cpp_int wide(Int128 value) {
  return (cpp_int(static_cast<std::int64_t>(value >> 64)) << 64) +
         static_cast<std::uint64_t>(value);
}

// The largest coordinates and w that the type allows: nothing may overflow.
TEST(HomogeneousPoint, DeterminantsAreThoseOfFractions) {
  std::mt19937_64 random(1);
  const auto between = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  const auto point = [&] {
    const std::int64_t w = between(0, 1) == 0 ? kLargestW : between(1, kLargestW);
    const auto coordinate = [&] {
      const std::int64_t most = w << 14;
      return between(0, 1) == 0 ? between(-most, most) : most * (2 * between(0, 1) - 1);
    };
    const std::int64_t x = coordinate();
    return HomogeneousPoint{x, coordinate(), w};
  };
  for (int i = 0; i < 5000; ++i) {
    const HomogeneousPoint a = point();
    const HomogeneousPoint b = point();
    const HomogeneousPoint p = i % 2 == 0 ? point() : homogeneous_centre(between(-99, 4200), 4095);
    ASSERT_EQ(cpp_rational(wide(cross(a, b, p))), turn(a, b, p) * a.w * b.w * p.w);
    ASSERT_EQ(cross(a, b, a), 0);
  }
}

TEST(HomogeneousPoint, IsTheOriginAtFirst) {
  const HomogeneousPoint origin;
  EXPECT_EQ(origin.x, 0);
  EXPECT_EQ(origin.y, 0);
  EXPECT_EQ(origin.w, 1);
}

TEST(HomogeneousPoint, EqualsItsMultiples) {
  EXPECT_TRUE(same_point({1, 2, 3}, {5, 10, 15}));
  EXPECT_FALSE(same_point({1, 2, 3}, {5, 10, 14}));
  EXPECT_FALSE(same_point({1, 2, 3}, {1, 3, 3}));
  EXPECT_FALSE(same_point({1, 2, 3}, {2, 2, 3}));
  EXPECT_TRUE(same_point(homogeneous(pixel_centre(3, -2)), homogeneous_centre(3, -2)));
}

TEST(HomogeneousPoint, MovesByPartsOfAPixel) {
  EXPECT_TRUE(same_point(moved({1, 2, 3}, 1, -1, 8), {11, 13, 24}));
  EXPECT_TRUE(same_point(moved({1, 2, 3}, 0, -3, 2), {2, -5, 6}));
}

TEST(HomogeneousPoint, HasANearestMultipleWithTiesToTheRightAndUp) {
  const auto raw = [](std::int64_t x, std::int64_t w) {
    return nearest_point({x, -x, w}).x.raw() * 1000000 + nearest_point({x, -x, w}).y.raw();
  };
  EXPECT_EQ(raw(1, 3), 21845 * 1000000LL - 21845);
  EXPECT_EQ(raw(2, 3), 43691 * 1000000LL - 43691);
  EXPECT_EQ(raw(1, 131072), 1 * 1000000LL - 0);
  EXPECT_EQ(raw(3, 131072), 2 * 1000000LL - 1);
  EXPECT_EQ(raw(7, 65536), 7 * 1000000LL - 7);
  EXPECT_EQ(raw(7, 32768), 14 * 1000000LL - 14);
  EXPECT_EQ(nearest_point({kLargestW << 13, 0, kLargestW}).x, Fixed::from_integer(1 << 13));
}

}  // namespace
}  // namespace edgecase
