// SPDX-License-Identifier: MIT
//
// Quotients that are multiples of 2^-16 after all: whatever their w, every predicate must decide as
// the one for multiples of 2^-16 does. All triangles, segments and points of small grids.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/homogeneous_line.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/point_ownership.h"

namespace edgecase {
namespace {

// All points from 0 to `size` pixels in steps of 1/parts.
std::vector<Point> grid(int size, int parts) {
  std::vector<Point> points;
  for (int y = 0; y <= size * parts; ++y)
    for (int x = 0; x <= size * parts; ++x)
      points.push_back(
          {Fixed::from_raw(x * Fixed::kOne / parts), Fixed::from_raw(y * Fixed::kOne / parts)});
  return points;
}

// Writes points of the grid of 1/4 with other w: small and large, even and odd multiples of 4.
class Weights {
 public:
  HomogeneousPoint operator()(Point p) {
    constexpr std::int64_t kQuarter = Fixed::kOne / 4;
    const auto by = static_cast<std::int64_t>(1 + (random_() >> (random_() % 30 + 2)));
    return {p.x.raw() / kQuarter * by, p.y.raw() / kQuarter * by, 4 * by};
  }

 private:
  std::mt19937 random_{5};
};

TEST(HomogeneousTriangle, DecidesAsTheDyadicOne) {
  Weights weighted;
  const auto points = grid(2, 2);
  long covered = 0;
  for (Point a : points)
    for (Point b : points)
      for (Point c : points) {
        const HomogeneousTriangle t = {weighted(a), weighted(b), weighted(c)};
        ASSERT_EQ(nearest_triangle(t), (Triangle{a, b, c}));
        for (const TieRule& ties : all_tie_rules())
          for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 2; ++x) {
              const bool inside = triangle_covers(Triangle{a, b, c}, x, y, ties);
              ASSERT_EQ(triangle_covers(t, x, y, ties), inside) << ties.name;
              covered += inside ? 1 : 0;
            }
      }
  EXPECT_GT(covered, 10000);
}

TEST(HomogeneousSegment, DecidesAsTheDyadicOne) {
  Weights weighted;
  const auto points = grid(3, 4);
  long covered = 0;
  for (Point a : points)
    for (Point b : points) {
      const Segment segment{a, b};
      const HomogeneousSegment other{weighted(a), weighted(b)};
      ASSERT_EQ(other.x_major(), segment.x_major());
      for (const DiamondBoundary& boundary : all_diamond_boundaries())
        for (int y = -1; y <= 3; ++y)
          for (int x = -1; x <= 3; ++x) {
            const bool meets = meets_diamond(segment, x, y, boundary);
            const bool ends = ends_in_diamond(segment, x, y, boundary);
            ASSERT_EQ(meets_diamond(other, x, y, boundary), meets) << boundary.name;
            ASSERT_EQ(ends_in_diamond(other, x, y, boundary), ends) << boundary.name;
            covered += meets && !ends ? 1 : 0;
          }
    }
  EXPECT_GT(covered, 100000);
}

TEST(HomogeneousSegment, IsDrawnAsTheDyadicOneInEveryWidthAndAlgorithm) {
  Weights weighted;
  const PixelBounds bounds{-1, 0, 4, 3};
  const TieRule& ties = *find_tie_rule("left-top");
  const auto points = grid(3, 2);
  const auto sorted = [](std::vector<PixelPosition> pixels) {
    std::sort(pixels.begin(), pixels.end());
    return pixels;
  };
  for (Point a : points)
    for (Point b : points)
      for (LineAlgorithm algorithm : values_of<LineAlgorithm>())
        for (WideLine wide : values_of<WideLine>())
          for (int halves : {2, 3, 4, 8}) {
            const Fixed width = Fixed::from_raw(halves * Fixed::kOne / 2);
            const LineChoice choice{algorithm, find_diamond_boundary("left-bottom"), wide};
            ASSERT_EQ(sorted(line_pixels(HomogeneousSegment{weighted(a), weighted(b)}, width,
                                         bounds, choice, ties)),
                      sorted(line_pixels(Segment{a, b}, width, bounds, choice, ties)))
                << name_of(algorithm) << " " << name_of(wide) << " " << halves;
          }
}

TEST(HomogeneousPoint, DecidesAsTheDyadicOne) {
  Weights weighted;
  long covered = 0;
  for (Point p : grid(3, 4))
    for (int quarters = 1; quarters <= 13; ++quarters)
      for (PointOffset offset : {PointOffset::none, PointOffset::right_down})
        for (const TieRule& ties : all_tie_rules())
          for (int y = -1; y <= 3; ++y)
            for (int x = -1; x <= 3; ++x) {
              const Fixed size = Fixed::from_raw(quarters * Fixed::kOne / 4);
              const bool inside = point_covers(SizedPoint{moved(p, offset), size}, x, y, ties);
              ASSERT_EQ(point_covers({moved(weighted(p), offset), size}, x, y, ties), inside);
              covered += inside ? 1 : 0;
            }
  EXPECT_GT(covered, 10000);
}

}  // namespace
}  // namespace edgecase
