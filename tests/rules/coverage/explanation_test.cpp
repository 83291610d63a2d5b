// SPDX-License-Identifier: MIT
//
// What the coverage rules say of a pixel, word for word, and the figures that they draw of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

// One mark a line: role, the word closed, positions, label.
std::string drawn(const Figure& figure) {
  std::string text;
  for (const Mark& mark : figure.marks) {
    text += name_of(mark.role);
    if (mark.closed) text += " closed";
    for (const auto& [x, y] : mark.points) text += fmt::format(" ({}, {})", x, y);
    if (!mark.label.empty()) text += " " + mark.label;
    text += "\n";
  }
  return text;
}

// -------------------------------------------------------------------------------------- lines

std::string line_text(Point a, Point b, int x, int y) {
  return explain_line({a, b}, x, y, *find_diamond_boundary("left-bottom")).text;
}

TEST(LineExplanation, SaysWhoGetsATouch) {
  EXPECT_EQ(line_text(at(0.5, 1), at(3.5, 1), 1, 0),
            "the segment (0.5, 1) to (3.5, 1) only touches the boundary of the diamond round (1.5, "
            "0.5), and as left-bottom has it enters it; its end (3.5, 1) lies outside the diamond");
  EXPECT_EQ(line_text(at(0.5, 1), at(3.5, 1), 1, 1),
            "the segment (0.5, 1) to (3.5, 1) only touches the boundary of the diamond round (1.5, "
            "1.5), and as left-bottom has it misses it; its end (3.5, 1) lies outside the diamond");
}

TEST(LineExplanation, SaysWhereTheEndLies) {
  EXPECT_EQ(line_text(at(0.5, 1), at(3.5, 1), 3, 0),
            "the segment (0.5, 1) to (3.5, 1) only touches the boundary of the diamond round (3.5, "
            "0.5), and as left-bottom has it misses it; its end (3.5, 1) lies exactly on the "
            "diamond's boundary and counts as outside");
  EXPECT_EQ(line_text(at(0.5, 0.5), at(1, 0.5), 0, 0),
            "the segment (0.5, 0.5) to (1, 0.5) comes within 0 of the centre (0.5, 0.5) (less than "
            "0.5, so it meets the diamond); its end (1, 0.5) lies exactly on the diamond's "
            "boundary and counts as inside, so it does not exit");
  EXPECT_EQ(line_text(at(0.4375, 0.5), at(0.5625, 0.5), 0, 0),
            "the segment (0.4375, 0.5) to (0.5625, 0.5) comes within 0 of the centre (0.5, 0.5) "
            "(less than 0.5, so it meets the diamond); its end (0.5625, 0.5) lies inside the "
            "diamond, so it does not exit");
  EXPECT_EQ(line_text(at(0.5, 0.5), at(3.5, 0.5), 1, 1),
            "the segment (0.5, 0.5) to (3.5, 0.5) comes within 1 of the centre (1.5, 1.5) (not "
            "less than 0.5, so it misses the diamond); its end (3.5, 0.5) lies outside the "
            "diamond");
}

TEST(LineExplanation, ASegmentWithoutLengthExitsNothing) {
  EXPECT_EQ(line_text(at(1.25, 2.5), at(1.25, 2.5), 1, 2),
            "the segment has no length: wherever (1.25, 2.5) lies in a diamond, the end lies there "
            "too, so it exits none");
}

TEST(LineExplanation, DrawsDiamondSampleAndSegment) {
  const Explanation why =
      explain_line({at(0.5, 4), at(3.5, 1)}, 1, 2, *find_diamond_boundary("left-bottom"));
  EXPECT_EQ(drawn(why.figure),
            "region closed (1, 2.5) (1.5, 2) (2, 2.5) (1.5, 3)\n"
            "sample (1.5, 2.5)\n"
            "edge (0.5, 4) (3.5, 1)\n");
}

// Smallest |dx| + |dy| from a centre to the points in which a segment between quarters crosses the
// lines of the quarter grid, its ends among them: the distance bends only there.
double nearest_crossing(Point a, Point b, Point centre) {
  const std::int64_t dx = b.x.raw() - a.x.raw();
  const std::int64_t dy = b.y.raw() - a.y.raw();
  double least = 1e9;
  for (const std::int64_t run : {std::abs(dx), std::abs(dy)}) {
    const std::int64_t steps = run / (Fixed::kOne / 4);
    for (std::int64_t step = 0; step <= steps; ++step) {
      const double t = steps == 0 ? 0 : static_cast<double>(step) / static_cast<double>(steps);
      const double x = a.x.to_double() + t * (b.x - a.x).to_double() - centre.x.to_double();
      const double y = a.y.to_double() + t * (b.y - a.y).to_double() - centre.y.to_double();
      least = std::min(least, std::abs(x) + std::abs(y));
    }
  }
  return least;
}

TEST(LineExplanation, SaysHowNearTheSegmentComes) {
  const std::string words = "comes within ";
  int seen = 0;
  for (int ax = 0; ax <= 12; ++ax)
    for (int ay = 0; ay <= 12; ++ay)
      for (int bx = 0; bx <= 12; bx += 2)
        for (int by = 1; by <= 12; by += 3) {
          const Point a = at(ax / 4., ay / 4.);
          const Point b = at(bx / 4., by / 4.);
          const std::string text = line_text(a, b, 1, 1);
          const std::size_t found = text.find(words);
          if (found == std::string::npos) continue;
          ++seen;
          // Printed with six digits.
          EXPECT_NEAR(std::strtod(text.c_str() + found + words.size(), nullptr),
                      nearest_crossing(a, b, at(1.5, 1.5)), 1e-5)
              << text;
        }
  EXPECT_GT(seen, 500);
}

// ------------------------------------------------------------------------------------- points

std::string point_text(const SizedPoint& point, int x, int y) {
  return explain_point(point, x, y, *find_tie_rule("right-top")).text;
}

TEST(PointExplanation, SaysInsideBoundaryAndOutside) {
  const SizedPoint wide{at(2.25, 1), Fixed::from_integer(3)};
  EXPECT_EQ(point_text(wide, 2, 1),
            "the pixel's centre (2.5, 1.5) lies inside the square of side 3 round the point (2.25, "
            "1) (0.5 from it along the axis where it is farther; 1.5 is the boundary)");
  EXPECT_NE(point_text(wide, 3, 1).find("lies inside the square"), std::string::npos);
  EXPECT_EQ(point_text(wide, 1, 2),
            "the pixel's centre (1.5, 2.5) lies exactly on the boundary of the square of side 3 "
            "round the point (2.25, 1) (1.5 from it along the axis where it is farther; 1.5 is the "
            "boundary); the tie is decided by right-top, so the centre counts as inside");
  EXPECT_EQ(point_text(wide, 1, -1),
            "the pixel's centre (1.5, -0.5) lies exactly on the boundary of the square of side 3 "
            "round the point (2.25, 1) (1.5 from it along the axis where it is farther; 1.5 is the "
            "boundary); the tie is decided by right-top, so the centre counts as outside");
  EXPECT_EQ(point_text(wide, 5, 1),
            "the pixel's centre (5.5, 1.5) lies outside the square of side 3 round the point "
            "(2.25, 1) (3.25 from it along the axis where it is farther; 1.5 is the boundary)");
}

TEST(PointExplanation, DrawsSquareAndSample) {
  const SizedPoint point{at(2.25, 1), Fixed::from_raw(Fixed::kOne / 2)};
  EXPECT_EQ(drawn(explain_point(point, 4, 3, *find_tie_rule("open")).figure),
            "region closed (2, 0.75) (2.5, 0.75) (2.5, 1.25) (2, 1.25)\n"
            "sample (4.5, 3.5)\n");
}

// ---------------------------------------------------------------------------------- triangles

// Its edges, counter-clockwise: bottom, right, left.
const Triangle kLowerLeft{at(0.5, 0.5), at(3.5, 0.5), at(0.5, 4.5)};
// Left, right, top; the vertices are given clockwise.
const Triangle kPointingDown{at(0.5, 2.5), at(2.5, 2.5), at(1.5, 0.5)};

std::string triangle_text(const Triangle& triangle, int x, int y) {
  return explain_triangle(triangle, x, y, *find_tie_rule("left-top")).text;
}

TEST(TriangleExplanation, NamesTheEdgeThatDecides) {
  EXPECT_EQ(triangle_text(kLowerLeft, 1, 1),
            "the sample (1.5, 1.5) lies 1 pixels inside the bottom edge (0.5, 0.5) to (3.5, 0.5)");
  EXPECT_EQ(triangle_text(kLowerLeft, 1, 2),
            "the sample (1.5, 2.5) lies 0.4 pixels inside the right edge (3.5, 0.5) to (0.5, 4.5)");
  EXPECT_EQ(triangle_text(kLowerLeft, 0, 1),
            "the sample (0.5, 1.5) lies exactly on the left edge (0.5, 4.5) to (0.5, 0.5), which "
            "left-top counts as inside");
  EXPECT_EQ(triangle_text(kLowerLeft, 1, 0),
            "the sample (1.5, 0.5) lies exactly on the bottom edge (0.5, 0.5) to (3.5, 0.5), which "
            "left-top counts as outside");
  EXPECT_EQ(triangle_text(kLowerLeft, 3, 3),
            "the sample (3.5, 3.5) lies 1.8 pixels outside the right edge (3.5, 0.5) to (0.5, "
            "4.5)");
  EXPECT_EQ(triangle_text(kLowerLeft, -3, -1),
            "the sample (-2.5, -0.5) lies 3 pixels outside the left edge (0.5, 4.5) to (0.5, 0.5)");
  EXPECT_EQ(triangle_text(kLowerLeft, 1, -3),
            "the sample (1.5, -2.5) lies 3 pixels outside the bottom edge (0.5, 0.5) to (3.5, "
            "0.5)");
  EXPECT_EQ(triangle_text(kPointingDown, 1, 2),
            "the sample (1.5, 2.5) lies exactly on the top edge (2.5, 2.5) to (0.5, 2.5), which "
            "left-top counts as inside");
  EXPECT_EQ(triangle_text(kPointingDown, 0, 0),
            "the sample (0.5, 0.5) lies 0.894427 pixels outside the left edge (0.5, 2.5) to (1.5, "
            "0.5)");
}

// The nearest that a sample can be to an edge without lying on it: its cross product is one unit.
TEST(TriangleExplanation, OneUnitIsInside) {
  const double unit = 1.0 / 65536;
  const Point a = at(0.5 - 3 * unit, 0.5 - 2 * unit);
  const Point b = at(a.x.to_double() + 3 + 2 * unit, a.y.to_double() + 2 + unit);
  const std::string text = triangle_text({a, b, at(0, 8)}, 0, 0);
  EXPECT_NE(text.find(" pixels inside the right edge"), std::string::npos) << text;
  const std::string outside = triangle_text({a, b, at(8, 0)}, 0, 0);
  EXPECT_NE(outside.find(" pixels outside the left edge"), std::string::npos) << outside;
}

TEST(TriangleExplanation, WithoutAreaThereIsNoEdge) {
  const Triangle flat{at(0, 1), at(1.5, 2), at(3, 3)};
  const Explanation why = explain_triangle(flat, 1, 1, *find_tie_rule("left-top"));
  EXPECT_EQ(why.text, "the triangle (0, 1) (1.5, 2) (3, 3) has no area and draws nothing");
  EXPECT_EQ(drawn(why.figure), "sample (1.5, 1.5)\n");
}

TEST(TriangleExplanation, DrawsTheEdgeThatDecidesAndThoseThatAreOwned) {
  EXPECT_EQ(drawn(explain_triangle(kLowerLeft, 1, 2, *find_tie_rule("left-bottom")).figure),
            "sample (1.5, 2.5)\n"
            "edge (3.5, 0.5) (0.5, 4.5) right\n"
            "owned (0.5, 0.5) (3.5, 0.5)\n"
            "owned (0.5, 4.5) (0.5, 0.5)\n");
  EXPECT_EQ(drawn(explain_triangle(kPointingDown, 2, 1, *find_tie_rule("right-top")).figure),
            "sample (2.5, 1.5)\n"
            "edge (1.5, 0.5) (2.5, 2.5) right\n"
            "owned (1.5, 0.5) (2.5, 2.5)\n"
            "owned (2.5, 2.5) (0.5, 2.5)\n");
}

}  // namespace
}  // namespace edgecase
