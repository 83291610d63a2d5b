// SPDX-License-Identifier: MIT
//
// True quotients against fractions without bounds: small w such as 3, 5 and 7, for which samples
// lie on edges and corners, and the largest w and coordinates that there are.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "rules/coverage/homogeneous_line.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/window.h"
#include "tests/oracles/quotients.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

class Quotients {
 public:
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  // Within 3 by 3 pixels, of one of the small w; often so that two times it is whole.
  HomogeneousPoint small() {
    constexpr std::int64_t kW[] = {1, 2, 3, 5, 6, 7, 9, 10, 14, 35};
    const std::int64_t w = kW[between(0, 9)];
    return {between(0, 3 * w), between(0, 3 * w), w};
  }
  // The same with any w that clip coordinates can have, as exact/homogeneous.h bounds it.
  HomogeneousPoint large() {
    const std::int64_t w = between(1, std::int64_t{1} << 32);
    return {between(0, 3 * w), between(0, 3 * w), w};
  }
  HomogeneousPoint any(int round) { return round % 4 == 3 ? large() : small(); }
  // On the other side of a pixel's centre, as far from it: the line to there runs through it.
  HomogeneousPoint opposite(const HomogeneousPoint& p) {
    return {(2 * between(0, 2) + 1) * p.w - p.x, (2 * between(0, 2) + 1) * p.w - p.y, p.w};
  }
  // On the far border of the range, for which the bounds of the products are made.
  HomogeneousPoint far() {
    const std::int64_t w = (std::int64_t{1} << 32) - between(0, 1);
    const auto coordinate = [&] { return between(0, 1) == 0 ? -(w << 13) : (w << 13) - 1; };
    return {coordinate(), coordinate(), w};
  }

 private:
  std::mt19937_64 random_{share_seed(11)};
};

std::array<oracle::Location, 3> divided(const HomogeneousTriangle& t) {
  return {oracle::divided(t[0]), oracle::divided(t[1]), oracle::divided(t[2])};
}

TEST(HomogeneousTriangle, HoldsTheSamplesThatFractionsSay) {
  Quotients random;
  long tied = 0;
  for (int round = 0; round < share_of(1500, 200); ++round) {
    HomogeneousTriangle t = {random.any(round), random.any(round), random.any(round)};
    if (round % 3 == 0) t[1] = random.opposite(t[0]);
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        for (const TieRule& ties : all_tie_rules())
          ASSERT_EQ(triangle_covers(t, x, y, ties),
                    oracle::triangle_has(divided(t), x, y, oracle::ties_named(ties.name)))
              << ties.name << " round " << round;
        tied += triangle_covers(t, x, y, *find_tie_rule("closed")) !=
                        triangle_covers(t, x, y, *find_tie_rule("open"))
                    ? 1
                    : 0;
      }
  }
  EXPECT_GT(tied, least_of(300)) << "samples on edges are what this is about";
}

TEST(HomogeneousTriangle, StaysWithinItsIntegersAtTheRangesCorners) {
  Quotients random;
  for (int round = 0; round < 400; ++round) {
    const HomogeneousTriangle t = {random.far(), random.far(), random.far()};
    for (int corner = 0; corner < 4; ++corner)
      for (const TieRule& ties : all_tie_rules()) {
        const int x = corner % 2 == 0 ? 0 : 4095;
        const int y = corner / 2 == 0 ? 0 : 4095;
        ASSERT_EQ(triangle_covers(t, x, y, ties),
                  oracle::triangle_has(divided(t), x, y, oracle::ties_named(ties.name)));
      }
  }
}

TEST(HomogeneousSegment, ExitsTheDiamondsThatFractionsSay) {
  Quotients random;
  long tied = 0;
  for (int round = 0; round < share_of(400, 60); ++round) {
    const HomogeneousSegment s{random.any(round), random.any(round)};
    const auto a = oracle::divided(s.a);
    const auto b = oracle::divided(s.b);
    for (const DiamondBoundary& boundary : all_diamond_boundaries())
      for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
          ASSERT_EQ(diamond_exit_covers(s, x, y, boundary),
                    oracle::segment_has(a, b, x, y, oracle::boundary_named(boundary.name)))
              << boundary.name << " round " << round;
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x)
        tied += meets_diamond(s, x, y, *find_diamond_boundary("closed")) !=
                        meets_diamond(s, x, y, *find_diamond_boundary("open"))
                    ? 1
                    : 0;
  }
  EXPECT_GT(tied, least_of(60));
}

TEST(HomogeneousSegment, StaysWithinItsIntegersAtTheRangesCorners) {
  Quotients random;
  for (int round = 0; round < share_of(100, 20); ++round) {
    const HomogeneousSegment given{random.far(), random.far()};
    const HomogeneousSegment wide = lowest_segment(given, 64);
    for (const HomogeneousSegment& s : {given, wide})
      for (const DiamondBoundary& boundary : all_diamond_boundaries())
        for (const int at : {-64, 0, 4159})
          ASSERT_EQ(diamond_exit_covers(s, at, 4095, boundary),
                    oracle::segment_has(oracle::divided(s.a), oracle::divided(s.b), at, 4095,
                                        oracle::boundary_named(boundary.name)));
  }
}

// A wide line lies (width - 1)/2 below its segment, exactly.
TEST(HomogeneousSegment, IsMovedExactlyForWideLines) {
  const HomogeneousSegment shallow = lowest_segment({{7, 5, 3}, {20, 8, 3}}, 4);
  EXPECT_TRUE(same_point(shallow.a, {14, 1, 6}));
  EXPECT_TRUE(same_point(shallow.b, {40, 7, 6}));
  const HomogeneousSegment steep = lowest_segment({{5, 7, 3}, {8, 20, 3}}, 4);
  EXPECT_TRUE(same_point(steep.a, {1, 14, 6}));
}

// A line 2^-18 above the border of row 0 and row 1; the nearest multiples of 2^-16 lie on it, and
// are row 0's.
TEST(HomogeneousSegment, IsDrawnAsItIsByTheRuleAndFromNearestMultiplesOtherwise) {
  constexpr std::int64_t kW = std::int64_t{1} << 18;
  const HomogeneousSegment above{{kW / 4, kW + 1, kW}, {3 * kW + 3 * kW / 4, kW + 1, kW}};
  const PixelBounds bounds{0, -4, 7, 4};
  const auto rows = [&](int width, LineAlgorithm algorithm, WideLine wide) {
    std::set<int> result;
    const LineChoice choice{algorithm, find_diamond_boundary("left-bottom"), wide};
    for (PixelPosition p :
         line_pixels(above, Fixed::from_integer(width), bounds, choice, *find_tie_rule("left-top")))
      result.insert(p.y);
    return result;
  };
  for (const WideLine wide : values_of<WideLine>())
    EXPECT_EQ(rows(1, LineAlgorithm::diamond_exit, wide), (std::set{1})) << name_of(wide);
  EXPECT_EQ(rows(3, LineAlgorithm::diamond_exit, WideLine::replicate), (std::set{0, 1, 2}));
}

TEST(HomogeneousPoint, HoldsTheSamplesThatFractionsSay) {
  Quotients random;
  long tied = 0;
  for (int round = 0; round < share_of(6000, 1000); ++round) {
    const HomogeneousPoint vertex = random.any(round);
    const Fixed size = Fixed::from_raw(random.between(1, 12) * Fixed::kOne / 4);
    const PointOffset offset = round % 2 == 0 ? PointOffset::none : PointOffset::right_down;
    auto at = oracle::divided(vertex);
    if (offset == PointOffset::right_down) {
      at.x += oracle::Fraction(1, 8);
      at.y -= oracle::Fraction(1, 8);
    }
    const HomogeneousSizedPoint point{moved(vertex, offset), size};
    const int x = static_cast<int>(random.between(0, 2));
    const int y = static_cast<int>(random.between(0, 2));
    for (const TieRule& ties : all_tie_rules())
      ASSERT_EQ(point_covers(point, x, y, ties),
                oracle::point_has(at, oracle::Fraction(size.raw(), Fixed::kOne), x, y,
                                  oracle::ties_named(ties.name)))
          << ties.name << " round " << round;
    tied += point_covers(point, x, y, *find_tie_rule("closed")) !=
                    point_covers(point, x, y, *find_tie_rule("open"))
                ? 1
                : 0;
  }
  EXPECT_GT(tied, least_of(50));
}

// Rounded once: 1/3 pixel and the like, ties, and the ends of the range, in every snap.
TEST(Snap, RoundsQuotientsOnce) {
  Quotients random;
  for (int round = 0; round < share_of(3000, 500); ++round) {
    HomogeneousPoint p = round % 5 == 4 ? random.far() : random.any(round);
    // Halves of a step of 12 bits, with a w that hides them.
    if (round % 5 == 3) {
      const std::int64_t by = random.between(1, 1 << 19);
      p = {random.between(-9000, 9000) * by, random.between(-9000, 9000) * by, by << 13};
    }
    for (Snap snap : all_snaps()) {
      const std::string name = name_of(snap);
      const std::string rounding = snap.is_none() ? "half-up" : name.substr(name.find('-') + 1);
      const auto at = oracle::divided(p);
      ASSERT_EQ(snap(p), (Point{oracle::snapped(at.x, snap.bits, rounding),
                                oracle::snapped(at.y, snap.bits, rounding)}))
          << name;
      const Point dyadic{Fixed::from_raw(p.x % 100000), Fixed::from_raw(p.y % 100000)};
      ASSERT_EQ(snap(homogeneous(dyadic)), snap(dyadic)) << name;
      ASSERT_EQ(snap(moved(homogeneous(dyadic), 0, 0, 3)), snap(dyadic)) << name;
    }
  }
}

}  // namespace
}  // namespace edgecase
