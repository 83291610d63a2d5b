// SPDX-License-Identifier: MIT
//
// Drawn examples of the diamond-exit rule, worked out by hand from GL 4.6 core, 14.5.1.
#include "rules/coverage/diamond_exit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <utility>
#include <vector>

#include "rules/coverage/segment.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

const DiamondBoundary& gl() {
  return *find_diamond_boundary("left-bottom");
}

std::string draw(Point a, Point b, int width, int height) {
  std::string rows;
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) rows += diamond_exit_covers({a, b}, x, y, gl()) ? '#' : '.';
    rows += '/';
  }
  return rows;
}

TEST(DiamondExit, IsHalfOpenBetweenPixelCentres) {
  EXPECT_EQ(draw(at(0.5, 0.5), at(3.5, 0.5), 5, 1), "###../");
  EXPECT_EQ(draw(at(3.5, 0.5), at(0.5, 0.5), 5, 1), ".###./");
  EXPECT_EQ(draw(at(0.5, 0.5), at(0.5, 3.5), 1, 5), "././#/#/#/");
}

// Moved by -(e, e^2), a horizontal line at integer y runs e^2 below it, from left of x = 0.5 to
// left of x = 3.5. It enters the diamonds of the row below at their top corners, at x = 0.5, 1.5
// and 2.5; the one at 3.5 lies e ahead of its end.
TEST(DiamondExit, AnIntegerRowGoesToTheRowBelow) {
  EXPECT_EQ(draw(at(0.5, 1), at(3.5, 1), 4, 2), "..../###./");
}

TEST(DiamondExit, AnIntegerColumnGoesToTheColumnLeft) {
  EXPECT_EQ(draw(at(1, 0.5), at(1, 2.5), 2, 3), "../#./#./");
}

TEST(DiamondExit, ZeroLengthDrawsNothing) {
  for (double x : {0.5, 0.25, 1.0}) EXPECT_EQ(draw(at(x, 0.5), at(x, 0.5), 2, 1), "../");
}

TEST(DiamondExit, ASegmentInsideOneDiamondDrawsNothing) {
  EXPECT_EQ(draw(at(0.4375, 0.5), at(0.5625, 0.5), 2, 1), "../");
}

TEST(DiamondExit, AnEndOnTheFarCornerHasExited) {
  // The right corner of pixel 0 is (1, 0.5); moved by -(e, e^2) it lies inside the diamond.
  EXPECT_EQ(draw(at(0.5, 0.5), at(1, 0.5), 2, 1), "../");
  // The left corner of pixel 1, from the right: moved left it lies outside, in no diamond at all.
  EXPECT_EQ(draw(at(1.5, 0.5), at(1, 0.5), 2, 1), ".#/");
}

TEST(DiamondExit, SlopeOneCountsAsXMajor) {
  EXPECT_TRUE((Segment{at(0, 0), at(2, 2)}).x_major());
  EXPECT_TRUE((Segment{at(0, 0), at(2, -2)}).x_major());
  EXPECT_FALSE((Segment{at(0, 0), at(1, 2)}).x_major());
  EXPECT_EQ(draw(at(0.5, 0.5), at(3.5, 3.5), 4, 4), "..../..#./.#../#.../");
}

TEST(DiamondExit, CoordinatesAtTheEndOfTheRangeDoNotOverflow) {
  const double far = 8192;
  const double tiny = 1.0 / 65536;
  const Segment segment{at(-far, -far), at(far, far - tiny)};
  EXPECT_TRUE(meets_diamond(segment, 0, 0, gl()));
  EXPECT_FALSE(meets_diamond(segment, 8191, -8192, gl()));
  EXPECT_EQ(diamond_exit_pixels(segment, {0, 0, 99, 99}, gl()).size(), 100u);
}

// All segments between quarters of pixels in 3x3 pixels.
TEST(DiamondExit, BoundariesMatterAtTiedPixelsAlone) {
  constexpr int kSteps = 12;
  const PixelBounds bounds{-1, -1, 3, 3};
  std::size_t tied = 0;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j)
      for (int k = 0; k <= kSteps; ++k)
        for (int l = 0; l <= kSteps; ++l) {
          const Segment segment{at(i / 4., j / 4.), at(k / 4., l / 4.)};
          const std::vector<PixelPosition> found = tied_line_pixels(segment, bounds);
          tied += found.size();
          for (int y = bounds.y_min; y <= bounds.y_max; ++y)
            for (int x = bounds.x_min; x <= bounds.x_max; ++x) {
              if (std::ranges::find(found, PixelPosition{x, y}) != found.end()) continue;
              const bool drawn = diamond_exit_covers(segment, x, y, gl());
              for (const DiamondBoundary& boundary : all_diamond_boundaries())
                ASSERT_EQ(diamond_exit_covers(segment, x, y, boundary), drawn) << boundary.name;
            }
        }
  std::printf("%zu tied pixels\n", tied);
  EXPECT_GT(tied, 10'000u);
}

// Long segments, of which most pixels lie far from both ends.
TEST(DiamondExit, BoundariesMatterAtTiedPixelsAloneOfLongSegments) {
  std::mt19937 random(3);
  const PixelBounds bounds{0, 0, 39, 39};
  std::size_t tied = 0;
  const auto any = [&](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most + 1));
  };
  for (int i = 0; i < 3000; ++i) {
    const int steps = 1 << any(3);
    const double run = any(40 * steps), rise = i % 3 == 0 ? run : any(40 * steps);
    const Point a = at(any(8) / 8., any(8 * steps) * 1. / steps);
    const double sign = any(1) == 0 ? 1 : -1;
    const Point b{
        a.x + Fixed::from_raw(static_cast<std::int64_t>(run / steps * Fixed::kOne)),
        a.y + Fixed::from_raw(static_cast<std::int64_t>(sign * rise / steps * Fixed::kOne))};
    const Segment segment = any(1) == 0 ? Segment{a, b} : Segment{b, a};
    const std::vector<PixelPosition> found = tied_line_pixels(segment, bounds);
    std::vector<PixelPosition> wanted;
    visit_pixels_near(segment, bounds, [&](PixelPosition p) {
      const auto differs = [&](const DiamondBoundary& boundary) {
        return meets_diamond(segment, p.x, p.y, boundary) != meets_diamond(segment, p.x, p.y, gl());
      };
      const auto ends_so = [&](const DiamondBoundary& boundary) {
        return ends_in_diamond(segment, p.x, p.y, boundary) !=
               ends_in_diamond(segment, p.x, p.y, gl());
      };
      const auto boundaries = all_diamond_boundaries();
      if (std::ranges::any_of(boundaries, differs) || std::ranges::any_of(boundaries, ends_so))
        wanted.push_back(p);
    });
    ASSERT_EQ(found, wanted) << i;
    tied += found.size();
  }
  std::printf("%zu tied pixels\n", tied);
  EXPECT_GT(tied, 1'000u);
}

// Nothing is tied where nothing lies on a quarter.
TEST(DiamondExit, FewPixelsAreTied) {
  EXPECT_TRUE(tied_line_pixels({at(.53125, .59375), at(3.40625, 1.8125)}, {0, 0, 4, 4}).empty());
  const std::vector<PixelPosition> expected = {{0, 0}, {1, 0}, {2, 0}, {3, 0},
                                               {0, 1}, {1, 1}, {2, 1}, {3, 1}};
  std::vector<PixelPosition> found = tied_line_pixels({at(.5, 1), at(3.5, 1)}, {0, 0, 4, 4});
  std::ranges::sort(found, {}, [](PixelPosition p) { return std::pair{p.y, p.x}; });
  EXPECT_EQ(found, expected);
}

TEST(DiamondExit, ExplanationNamesTheTieAndTheNumbers) {
  const std::string tie = explain_line({at(0.5, 1), at(3.5, 1)}, 1, 0, gl()).text;
  EXPECT_NE(tie.find("only touches"), std::string::npos) << tie;
  const std::string miss = explain_line({at(0.5, 0.5), at(3.5, 0.5)}, 1, 1, gl()).text;
  EXPECT_NE(miss.find("comes within 1 of the centre (1.5, 1.5)"), std::string::npos) << miss;
}

}  // namespace
}  // namespace edgecase
