// SPDX-License-Identifier: MIT
//
// The catalogue of line algorithms: names, widths, and drawn examples where the oracles' grids do
// not reach.
#include "rules/coverage/line_algorithm.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "rules/all_rules.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/line_areas.h"
#include "rules/coverage/scan_conversion.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

constexpr PixelBounds kTarget{0, 0, 15, 15};

Pixels drawn(const Segment& segment, Fixed width, WideLine wide, LineAlgorithm algorithm) {
  LineChoice choice;
  choice.algorithm = algorithm;
  choice.boundary = find_diamond_boundary("left-bottom");
  choice.wide = wide;
  return sorted(line_pixels(segment, width, kTarget, choice, *find_tie_rule("left-top")));
}

// --------------------------------------------------------------------------------------- widths

TEST(WideLines, WidthsRoundToTheNearestAndAreAtLeastOne) {
  const auto rounded = [](double width) { return rounded_width(at(width, 0).x); };
  EXPECT_EQ(rounded(1.0 / 65536), 1);
  EXPECT_EQ(rounded(0.25), 1);
  EXPECT_EQ(rounded(0.5), 1);
  EXPECT_EQ(rounded(1), 1);
  EXPECT_EQ(rounded(1.4375), 1);
  EXPECT_EQ(rounded(1.5 - 1.0 / 65536), 1);
  EXPECT_EQ(rounded(1.5), 2);
  EXPECT_EQ(rounded(2.5), 3);
  EXPECT_EQ(rounded(63.75), 64);
}

TEST(WideLines, TheLowestSegmentLiesHalfOfTheRestBelow) {
  const Segment shallow = lowest_segment({at(1, 5), at(9, 6)}, 4);
  EXPECT_EQ(shallow.a, at(1, 3.5));
  EXPECT_EQ(shallow.b, at(9, 4.5));
  const Segment steep = lowest_segment({at(5, 1), at(6, 9)}, 4);
  EXPECT_EQ(steep.a, at(3.5, 1));
  EXPECT_EQ(steep.b, at(4.5, 9));
}

TEST(WideLines, WidthOneIsDrawnByTheAlgorithmAlone) {
  // It ends in the diamond of column 6, whose centre an area would hold.
  const Segment segment{at(2.25, 5.5), at(6.75, 5.5)};
  const Pixels expected{{2, 5}, {3, 5}, {4, 5}, {5, 5}};
  for (WideLine wide : values_of<WideLine>())
    EXPECT_EQ(drawn(segment, Fixed::from_integer(1), wide, LineAlgorithm::diamond_exit), expected)
        << name_of(wide);
}

// ----------------------------------------------------------------------------- shifted triangles

// The corners written out: half a pixel back along the line, 1/8 down (right, if y-major).
struct Shifted {
  Segment segment;
  Point start[2];  // on the lower (left) side and on the other
  Point end[2];
};

TEST(ShiftedTriangles, AreTheTwoOfTheMovedParallelogram) {
  constexpr double kHigh = 5 + 8520. / 65536;    // 1.375 more passes a row's centre by 0.005
  constexpr double kRight = 5 + 57016. / 65536;  // 1.375 less falls short of a column's by 0.005
  const Shifted examples[] = {
      {{at(2, 5), at(10, 8)}, {at(1.5, 3.375), at(1.5, 6.375)}, {at(9.5, 6.375), at(9.5, 9.375)}},
      {{at(10, 8), at(2, 5)}, {at(10.5, 6.375), at(10.5, 9.375)}, {at(2.5, 3.375), at(2.5, 6.375)}},
      {{at(5, 2), at(8, 10)}, {at(3.625, 1.5), at(6.625, 1.5)}, {at(6.625, 9.5), at(9.625, 9.5)}},
      {{at(8, 10), at(5, 2)}, {at(6.625, 10.5), at(9.625, 10.5)}, {at(3.625, 2.5), at(6.625, 2.5)}},
      // Sides between two rows (columns) of centres, which a ninth or a seventh would not keep.
      {{at(2, kHigh), at(10, kHigh)},
       {at(1.5, kHigh - 1.625), at(1.5, kHigh + 1.375)},
       {at(9.5, kHigh - 1.625), at(9.5, kHigh + 1.375)}},
      {{at(kRight, 2), at(kRight, 10)},
       {at(kRight - 1.375, 1.5), at(kRight + 1.625, 1.5)},
       {at(kRight - 1.375, 9.5), at(kRight + 1.625, 9.5)}},
      // 45 degrees counts as y-major.
      {{at(3, 3), at(9, 9)}, {at(1.625, 2.5), at(4.625, 2.5)}, {at(7.625, 8.5), at(10.625, 8.5)}},
      {{at(3, 9), at(9, 3)}, {at(1.625, 9.5), at(4.625, 9.5)}, {at(7.625, 3.5), at(10.625, 3.5)}},
  };
  for (const Shifted& example : examples) {
    Pixels expected =
        scanned_triangle_pixels({example.start[0], example.end[0], example.end[1]}, kTarget);
    for (PixelPosition p :
         scanned_triangle_pixels({example.start[0], example.end[1], example.start[1]}, kTarget))
      expected.push_back(p);
    EXPECT_GT(expected.size(), 15u);
    EXPECT_EQ(drawn(example.segment, Fixed::from_integer(3), WideLine::shifted_triangles,
                    LineAlgorithm::diamond_exit),
              sorted(expected));
  }
}

// Which diagonal divides the parallelogram shows where single precision leaves a pixel to neither
// triangle, or to both.
TEST(ShiftedTriangles, AreDividedFromTheLowerStart) {
  const Segment segment{at(12.5, 8.5625), at(5.75, 13.4375)};
  const Point start[] = {at(13, 6.625), at(13, 10.25)};
  const Point end[] = {at(6.25, 11.5), at(6.25, 15.125)};
  const auto both = [&](const Triangle& one, const Triangle& other) {
    Pixels pixels = scanned_triangle_pixels(one, kTarget);
    for (PixelPosition p : scanned_triangle_pixels(other, kTarget)) pixels.push_back(p);
    return sorted(pixels);
  };
  const Pixels expected = both({start[0], end[0], end[1]}, {start[0], end[1], start[1]});
  EXPECT_NE(expected, both({start[1], end[1], end[0]}, {start[1], end[0], start[0]}));
  EXPECT_EQ(
      drawn(segment, at(3.625, 0).x, WideLine::shifted_triangles, LineAlgorithm::diamond_exit),
      expected);
}

// ---------------------------------------------------------------------------------------- areas

Pixels area(const Segment& segment, double width, LineArea kind, const char* ties) {
  return sorted(line_area_pixels(segment, at(width, 0).x, kind, kTarget, *find_tie_rule(ties)));
}

TEST(LineAreas, WithoutLengthThereIsNone) {
  for (LineArea kind : {LineArea::rectangle, LineArea::parallelogram}) {
    EXPECT_TRUE(area({at(3.5, 3.5), at(3.5, 3.5)}, 4, kind, "closed").empty());
    EXPECT_FALSE(line_area_covers({at(3.5, 3.5), at(3.5, 3.5)}, Fixed::from_integer(4), kind,
                                  {3, 3}, *find_tie_rule("closed")));
  }
}

// A length of one raw unit, between two multiples: its ends' perpendiculars hold the centre.
TEST(LineAreas, OfTheShortestSegments) {
  const double unit = 1.0 / 65536;
  const Pixels column{{3, 2}, {3, 3}, {3, 4}};
  const Pixels row{{2, 3}, {3, 3}, {4, 3}};
  for (LineArea kind : {LineArea::rectangle, LineArea::parallelogram})
    for (double sign : {-1.0, 1.0}) {
      EXPECT_EQ(area({at(3.5, 3.5), at(3.5 + sign * unit, 3.5)}, 3, kind, "closed"), column);
      EXPECT_EQ(area({at(3.5, 3.5), at(3.5, 3.5 + sign * unit)}, 3, kind, "closed"), row);
    }
}

// A centre exactly half the width from a line, both a unit long or so: which side it lies on
// counts.
TEST(LineAreas, OfTheThinnestLines) {
  const double unit = 1.0 / 65536;
  const Fixed width = Fixed::from_raw(2);
  const Segment below{at(0.5, 0.5 - unit), at(0.5 + unit, 0.5 - unit)};
  const Segment above{at(0.5, 0.5 + unit), at(0.5 + unit, 0.5 + unit)};
  const auto holds = [&](const Segment& segment, const char* ties) {
    return line_area_covers(segment, width, LineArea::rectangle, {0, 0}, *find_tie_rule(ties));
  };
  // The centre lies on the top side of the one and on the bottom side of the other.
  EXPECT_FALSE(holds(below, "left-bottom"));
  EXPECT_TRUE(holds(below, "left-top"));
  EXPECT_TRUE(holds(above, "left-bottom"));
  EXPECT_FALSE(holds(above, "left-top"));
}

TEST(Walks, OfTheShortestSegments) {
  const double unit = 1.0 / 65536;
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(drawn({at(2.25, 5.25), at(2.25 + sign * unit, 5.25)}, Fixed::from_integer(1),
                    WideLine::replicate, LineAlgorithm::walk_floor_to_floor),
              (Pixels{{2, 5}}));
    EXPECT_EQ(drawn({at(5.25, 2.25), at(5.25, 2.25 + sign * unit)}, Fixed::from_integer(1),
                    WideLine::replicate, LineAlgorithm::walk_floor_to_floor),
              (Pixels{{5, 2}}));
  }
}

// Every pixel of the target tested, against the search along the segment.
TEST(LineAreas, TheSearchMissesNothing) {
  for (int ax = -6; ax <= 38; ax += 5)
    for (int ay = -6; ay <= 38; ay += 11)
      for (int bx = -9; bx <= 38; bx += 7)
        for (int by = -9; by <= 38; by += 6)
          for (const double width : {1.0, 2.5, 8.0}) {
            const Segment segment{at(ax / 2., ay / 2.), at(bx / 2., by / 2.)};
            for (LineArea kind : {LineArea::rectangle, LineArea::parallelogram}) {
              Pixels expected;
              for (int x = 0; x <= 15; ++x)
                for (int y = 0; y <= 15; ++y)
                  if (line_area_covers(segment, at(width, 0).x, kind, {x, y},
                                       *find_tie_rule("closed")))
                    expected.push_back({x, y});
              ASSERT_EQ(area(segment, width, kind, "closed"), expected)
                  << ax << " " << ay << " " << bx << " " << by << " " << width;
            }
          }
}

// ------------------------------------------------------------------------------------- one unit

// Segments of one raw unit beside a diamond's edges: no sign of a difference is lost.
TEST(DiamondParts, OfTheShortestSegments) {
  const double unit = 1.0 / 65536;
  const DiamondBoundary& scotty = *find_diamond_boundary("scotty3d");
  // Across the middle of the upper right edge of pixel (0, 0), both ways, then beside it.
  const Point edge = at(0.75, 0.75);
  for (const Point other : {at(0.75 + unit, 0.75), at(0.75, 0.75 + unit)}) {
    EXPECT_TRUE(meets_diamond({edge, other}, 0, 0, scotty));
    EXPECT_TRUE(meets_diamond({other, edge}, 0, 0, scotty));
    EXPECT_TRUE(ends_in_diamond({other, edge}, 0, 0, scotty));
    EXPECT_FALSE(ends_in_diamond({edge, other}, 0, 0, scotty));
  }
  // Up to the lower left edge, next to the bottom corner; a pixel further right, the same.
  for (int x : {0, 1}) {
    const Segment touching{at(x + 0.5 - unit, 0), at(x + 0.5 - unit, unit)};
    EXPECT_TRUE(meets_diamond(touching, x, 0, scotty));
    EXPECT_TRUE(meets_diamond({touching.b, touching.a}, x, 0, scotty));
  }
  // Right of it, where the coordinates across the edge are no mirror images.
  for (const Point other : {at(2.75 + unit, 0.75), at(2.75, 0.75 + unit)})
    EXPECT_TRUE(meets_diamond({at(2.75, 0.75), other}, 2, 0, scotty));
  const Point aside = at(0.75 + unit, 0.75);
  for (const Point other : {at(0.75 + 2 * unit, 0.75), at(0.75 + unit, 0.75 + unit)}) {
    EXPECT_FALSE(meets_diamond({aside, other}, 0, 0, scotty));
    EXPECT_FALSE(meets_diamond({other, aside}, 0, 0, scotty));
  }
}

// Rectangles and parallelograms are areas, at width 1 and as the wide form; what puts one column of
// pixels upon another is none, and no more are triangles that are placed otherwise.
TEST(LineAlgorithms, SomeFillAreas) {
  const auto fills = [](LineAlgorithm algorithm, WideLine wide, int width) {
    LineChoice choice;
    choice.algorithm = algorithm;
    choice.wide = wide;
    return fills_area(choice, Fixed::from_integer(width));
  };
  for (const LineAlgorithm algorithm : values_of<LineAlgorithm>()) {
    const bool is_area = algorithm == LineAlgorithm::rectangle ||
                         algorithm == LineAlgorithm::parallelogram ||
                         algorithm == LineAlgorithm::parallelogram_ends_tested;
    for (const WideLine wide : values_of<WideLine>()) {
      EXPECT_EQ(fills(algorithm, wide, 1), is_area) << name_of(algorithm);
      const bool is_wide_area =
          wide == WideLine::replicate ? is_area : wide != WideLine::shifted_triangles;
      EXPECT_EQ(fills(algorithm, wide, 2), is_wide_area) << name_of(algorithm);
      EXPECT_EQ(fills(algorithm, wide, 3), is_wide_area) << name_of(algorithm);
    }
  }
}

}  // namespace
}  // namespace edgecase
