// SPDX-License-Identifier: MIT
//
// Rounded corners of multisampled lines: drawings, and comparisons of squares in place of roots.
#include "rules/samples/rounded_rectangle.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <utility>

#include "exact/fixed.h"
#include "model/sampling.h"
#include "rules/coverage/line_areas.h"
#include "rules/coverage/window.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

class Random {
 public:
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(engine_);
  }
  Point point(int parts) {
    const std::int64_t step = Fixed::kOne / parts;
    const Fixed x = Fixed::from_raw(between(-parts, 9 * parts) * step);
    return {x, Fixed::from_raw(between(-parts, 9 * parts) * step)};
  }

 private:
  std::mt19937_64 engine_{11};
};

// The sign of value - above / sqrt(below): of squares, where neither sign decides.
int order(Int128 value, Int128 above, Int128 below) {
  if (sign(value) != sign(above)) return sign(value) > sign(above) ? 1 : -1;
  return sign(value) * sign(value * value * below - above * above);
}

// Is `rounded` a multiple of step nearest to whole + above / sqrt(below), and of two the one that
// is wanted? Such ties are counted.
::testing::AssertionResult is_nearest(Fixed rounded, std::int64_t whole, std::int64_t above,
                                      std::uint64_t below, std::int64_t step, HalfwayTo halfway,
                                      int& ties) {
  const Int128 twice = Int128{2} * (rounded.raw() - whole);
  const int half_below = order(twice - step, Int128{2} * above, below);
  const int half_above = order(twice + step, Int128{2} * above, below);
  const std::int64_t k = rounded.raw() / step;
  bool right = rounded.raw() % step == 0 && half_below <= 0 && half_above >= 0;
  if (half_below == 0 || half_above == 0) {
    ++ties;
    const bool is_farther = half_below == 0 ? k > 0 : k < 0;  // from 0 than the other one
    right = right && (halfway == HalfwayTo::even ? k % 2 == 0 : is_farther);
  }
  if (right) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << whole << " + " << above << " / sqrt(" << below
                                       << "), steps of " << step << ": " << rounded.raw();
}

TEST(SnappedRectangle, NearestOfManyNumbers) {
  Random random;
  int ties = 0;
  for (int round = 0; round < 20000; ++round) {
    // Every other one of a whole length: 3, 4 and 5 times something.
    const std::int64_t unit = random.between(1, 1 << 12) << random.between(0, 4);
    const bool rational = round % 2 == 0;
    const std::int64_t dx = rational ? 3 * unit : random.between(-(1 << 24), 1 << 24);
    const std::int64_t dy = rational ? 4 * unit : random.between(1, 1 << 24);
    const std::int64_t width = random.between(1, 64 * 16) << 12;
    const std::int64_t whole = random.between(-(1 << 12), 1 << 12) << random.between(4, 12);
    const auto below = static_cast<std::uint64_t>(4 * (dx * dx + dy * dy));
    const std::int64_t above = width * (random.between(0, 1) == 0 ? dx : -dy);
    for (const int bits : {4, 8})
      for (const HalfwayTo halfway : {HalfwayTo::even, HalfwayTo::away_from_zero})
        ASSERT_TRUE(is_nearest(nearest_with_root(whole, above, below, bits, halfway), whole, above,
                               below, Fixed::kOne >> bits, halfway, ties));
  }
  EXPECT_GT(ties, 200);
}

TEST(SnappedRectangle, NearestOfTheLargestNumbers) {
  int ties = 0;
  const std::int64_t whole = (std::int64_t{1} << 30) - 1;
  for (const std::int64_t above : {(std::int64_t{1} << 53) - 1, -(std::int64_t{1} << 53)})
    for (const std::uint64_t below : {std::uint64_t{1} << 62, ~std::uint64_t{0}})
      EXPECT_TRUE(is_nearest(nearest_with_root(whole, above, below, 8, HalfwayTo::even), whole,
                             above, below, 256, HalfwayTo::even, ties));
}

// Steps of 256.
TEST(SnappedRectangle, NearestByHand) {
  const auto nearest = [](std::int64_t whole, std::int64_t above, std::uint64_t below) {
    const auto to = [&](HalfwayTo halfway) {
      return nearest_with_root(whole, above, below, 8, halfway).raw();
    };
    return std::pair{to(HalfwayTo::even), to(HalfwayTo::away_from_zero)};
  };
  using Both = std::pair<std::int64_t, std::int64_t>;
  // Halves.
  EXPECT_EQ(nearest(0, 128, 1), Both(0, 256));
  EXPECT_EQ(nearest(0, -128, 1), Both(0, -256));
  EXPECT_EQ(nearest(128, 0, 1), Both(0, 256));
  EXPECT_EQ(nearest(-128, 0, 1), Both(0, -256));
  EXPECT_EQ(nearest(256, 256, 4), Both(512, 512));
  EXPECT_EQ(nearest(256, -256, 4), Both(0, 256));
  EXPECT_EQ(nearest(-256, -256, 4), Both(-512, -512));
  EXPECT_EQ(nearest(512, 384, 9), Both(512, 768));
  EXPECT_EQ(nearest(-1024, 384, 1), Both(-512, -768));
  // Beside them.
  EXPECT_EQ(nearest(128, 1, 1'000'000), Both(256, 256));
  EXPECT_EQ(nearest(128, -1, 1'000'000), Both(0, 0));
  EXPECT_EQ(nearest(-128, -1, 1'000'000), Both(-256, -256));
  EXPECT_EQ(nearest(127, 1, 1), Both(0, 256));
  EXPECT_EQ(nearest(129, -1, 1), Both(0, 256));
  // 181 / sqrt(2) is 127.99, 182 / sqrt(2) 128.69.
  EXPECT_EQ(nearest(0, 181, 2), Both(0, 0));
  EXPECT_EQ(nearest(0, 182, 2), Both(256, 256));
  EXPECT_EQ(nearest(0, -181, 2), Both(0, 0));
  EXPECT_EQ(nearest(0, -182, 2), Both(-256, -256));
}

// All directions of up to 5 steps, all ends at halves of a step, widths of up to 5 halves: of a
// sixteenth of a pixel and of a 256th.
TEST(SnappedRectangle, CornersOfEveryShortLine) {
  int ties = 0;
  const auto snapped = [&](Fixed end) {
    // The step that holds it, or the next one, whichever is_nearest lets through.
    Fixed rounded = Fixed::from_raw(end.raw() >> 8 << 8);
    if (!is_nearest(rounded, end.raw(), 0, 1, 256, HalfwayTo::away_from_zero, ties))
      rounded = rounded + Fixed::from_raw(256);
    EXPECT_TRUE(is_nearest(rounded, end.raw(), 0, 1, 256, HalfwayTo::away_from_zero, ties));
    return rounded;
  };
  const auto check = [&](const Segment& line, std::int64_t width) {
    const std::int64_t dx = (line.b.x - line.a.x).raw(), dy = (line.b.y - line.a.y).raw();
    const auto below = static_cast<std::uint64_t>(4 * (dx * dx + dy * dy));
    const Point ends[] = {line.a, line.b, line.b, line.a};
    const auto corners = rounded_corners(line, Fixed::from_raw(width), RectangleRounding::corners);
    const auto offset = rounded_corners(line, Fixed::from_raw(width), RectangleRounding::offset);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::int64_t w = i < 2 ? -width : width;
      ASSERT_TRUE(
          is_nearest(corners[i].x, ends[i].x.raw(), -w * dy, below, 4096, HalfwayTo::even, ties));
      ASSERT_TRUE(
          is_nearest(corners[i].y, ends[i].y.raw(), w * dx, below, 4096, HalfwayTo::even, ties));
      ASSERT_TRUE(is_nearest(offset[i].x - snapped(ends[i].x), 0, -w * dy, below, 256,
                             HalfwayTo::away_from_zero, ties));
      ASSERT_TRUE(is_nearest(offset[i].y - snapped(ends[i].y), 0, w * dx, below, 256,
                             HalfwayTo::away_from_zero, ties));
    }
  };
  for (const std::int64_t half : {2048, 128})
    for (std::int64_t i = 0; i < 11 * 11 * 4 * 4 * 5; ++i) {
      const auto digit = [&](std::int64_t divisor, std::int64_t count) {
        return i / divisor % count;
      };
      const std::int64_t dx = digit(1, 11) - 5, dy = digit(11, 11) - 5;
      if (dx == 0 && dy == 0) continue;
      const std::int64_t x = (digit(121, 4) - 2) * half, y = (digit(484, 4) - 2) * half;
      check({{Fixed::from_raw(x), Fixed::from_raw(y)},
             {Fixed::from_raw(x + 2 * half * dx), Fixed::from_raw(y + 2 * half * dy)}},
            (digit(1936, 5) + 1) * half);
    }
  EXPECT_GT(ties, 10000);
}

// Where all corners of the rectangle lie on the grid there is nothing to round.
TEST(SnappedRectangle, OnTheGridItIsTheRectangle) {
  const TieRule& ties = *find_tie_rule("left-bottom");
  Random random;
  int covered = 0;
  for (int round = 0; round < 800; ++round) {
    const Point a = random.point(16);
    const Fixed run = Fixed::from_raw(random.between(1, 64) * Fixed::kOne / 16);
    const bool level = round % 2 == 0;
    const Point b{level ? a.x + run : a.x, level ? a.y : a.y + run};
    const Fixed width = Fixed::from_integer(random.between(1, 3));
    for (const auto rounding : {RectangleRounding::offset, RectangleRounding::corners}) {
      const auto corners = rounded_corners({a, b}, width, rounding);
      for (int i = 0; i < 16; ++i) {
        const Point sample = random.point(16);
        const bool expected = line_area_covers({a, b}, width, LineArea::rectangle, sample, ties);
        EXPECT_EQ(rounded_rectangle_covers(corners, sample, ties), expected);
        covered += expected ? 1 : 0;
      }
    }
  }
  EXPECT_GT(covered, 500);
}

// Of a line of slope 3/4, n is (-3, 4) / 10 of the width.
TEST(SnappedRectangle, CornersByHand) {
  const Segment line{at(1, 1), at(5, 4)};
  const auto corners = rounded_corners(line, Fixed::from_integer(1), RectangleRounding::corners);
  // 0.3 and 0.4 of a pixel: 4.8 and 6.4 sixteenths.
  EXPECT_EQ(corners[0], at(1 + 5 / 16.0, 1 - 6 / 16.0));
  EXPECT_EQ(corners[1], at(5 + 5 / 16.0, 4 - 6 / 16.0));
  EXPECT_EQ(corners[2], at(5 - 5 / 16.0, 4 + 6 / 16.0));
  EXPECT_EQ(corners[3], at(1 - 5 / 16.0, 1 + 6 / 16.0));
  const auto offset = rounded_corners(line, Fixed::from_integer(1), RectangleRounding::offset);
  // 76.8 and 102.4 of 256.
  EXPECT_EQ(offset[0], at(1 + 77 / 256.0, 1 - 102 / 256.0));
  EXPECT_EQ(offset[3], at(1 - 77 / 256.0, 1 + 102 / 256.0));
}

// Ends are rounded to 1/256 pixel and no farther, a tie away from 0.
TEST(SnappedRectangle, EndsByHand) {
  const auto corners =
      rounded_corners({at(1 + 1 / 256.0, 1 + 1 / 512.0), at(3 + 3 / 512.0, 1 + 1 / 512.0)},
                      Fixed::from_integer(1), RectangleRounding::offset);
  EXPECT_EQ(corners[0], at(1 + 1 / 256.0, 0.5 + 1 / 256.0));
  EXPECT_EQ(corners[1], at(3 + 2 / 256.0, 0.5 + 1 / 256.0));
  EXPECT_EQ(corners[2], at(3 + 2 / 256.0, 1.5 + 1 / 256.0));
  EXPECT_EQ(corners[3], at(1 + 1 / 256.0, 1.5 + 1 / 256.0));
  const auto below = rounded_corners({at(-1 - 5 / 512.0, 0), at(-3, 0)}, Fixed::from_integer(1),
                                     RectangleRounding::offset);
  EXPECT_EQ(below[0], at(-1 - 3 / 256.0, 0.5));
}

// All rectangles along the axes between halves of a pixel around 3x3 pixels: literally, a border at
// a time.
TEST(SnappedRectangle, CrossesTheBordersThatLieInside) {
  const PixelBounds bounds{0, 0, 2, 2};
  const auto has_border = [](int least, int most) {
    for (int border = 0; border <= 2; ++border)
      if (least <= 2 * border && 2 * border < most) return true;
    return false;
  };
  int crossing = 0;
  for (int i = 0; i < 10 * 10 * 10 * 10; ++i) {
    const int x = i % 10 - 2, right = i / 10 % 10 - 2, y = i / 100 % 10 - 2, top = i / 1000 - 2;
    if (x >= right || y >= top) continue;
    const std::array corners = {at(x / 2.0, y / 2.0), at(right / 2.0, y / 2.0),
                                at(right / 2.0, top / 2.0), at(x / 2.0, top / 2.0)};
    const bool expected = has_border(x, right) && has_border(y, top);
    ASSERT_EQ(crosses_borders(corners, bounds), expected) << x << " " << y;
    crossing += expected ? 1 : 0;
  }
  EXPECT_GT(crossing, 500);
}

// 4 by 4 pixels, top row first.
std::string drawn(const Segment& line, RectangleRounding rounding, Point within, const char* ties) {
  std::string picture = "..../..../..../....";
  for (const PixelPosition pixel : rounded_rectangle_pixels(
           line, Fixed::from_integer(1), rounding, {0, 0, 3, 3}, within, *find_tie_rule(ties)))
    picture[static_cast<std::size_t>(5 * (3 - pixel.y) + pixel.x)] = '#';
  return picture;
}

// The exact rectangle reaches from just above 1 to just above 2, the rounded one from 1 to 2.
TEST(SnappedRectangle, ALevelLineIsRoundedDown) {
  const Segment line{at(0.25, 1.5 + 1 / 1024.0), at(3.25, 1.5 + 1 / 1024.0)};
  for (const auto rounding : {RectangleRounding::offset, RectangleRounding::corners}) {
    EXPECT_EQ(drawn(line, rounding, at(0.5, 0), "left-bottom"), "..../..../###./....");
    EXPECT_EQ(drawn(line, rounding, at(0.5, 0), "left-top"), "..../###./..../....");
    EXPECT_EQ(drawn(line, rounding, at(0.5, 0), "closed"), "..../###./###./....");
    EXPECT_EQ(drawn(line, rounding, at(0.5, 0), "open"), "..../..../..../....");
  }
}

// Of a diagonal the exact rectangle reaches to x - y = 0.7071, that of rounded offsets, 91/256, to
// 182/256, that of rounded corners, 6/16, to 12/16.
TEST(SnappedRectangle, ADiagonalIsRoundedOutwards) {
  const Segment line{at(0, 0), at(4, 4)};
  const char* narrow = "..#./.#../#.../....";
  const char* wide = "..##/.##./##../#...";
  for (const auto& [rounding, reach] : {std::pair{RectangleRounding::offset, 182 / 256.0},
                                        std::pair{RectangleRounding::corners, 12 / 16.0}}) {
    EXPECT_EQ(drawn(line, rounding, at(reach, 0), "closed"), wide);
    EXPECT_EQ(drawn(line, rounding, at(reach, 0), "open"), narrow);
    EXPECT_EQ(drawn(line, rounding, at(reach - 1 / 256.0, 0), "open"), wide);
    EXPECT_EQ(drawn(line, rounding, at(reach + 1 / 256.0, 0), "closed"), narrow);
  }
}

TEST(SnappedRectangle, PixelsAreThoseWhoseSamplesItHolds) {
  Random random;
  const PixelBounds bounds{0, 0, 9, 9};
  const TieRule& ties = *find_tie_rule("left-top");
  std::size_t covered = 0;
  for (int round = 0; round < 200; ++round) {
    const Segment line{random.point(256), random.point(256)};
    if (line.a == line.b) continue;
    const Fixed width = Fixed::from_raw(random.between(1, 24) * Fixed::kOne / 8);
    const Point within{Fixed::from_raw(random.between(0, 15) * 4096),
                       Fixed::from_raw(random.between(0, 15) * 4096)};
    for (const auto rounding : {RectangleRounding::offset, RectangleRounding::corners}) {
      const auto corners = rounded_corners(line, width, rounding);
      const auto pixels = rounded_rectangle_pixels(line, width, rounding, bounds, within, ties);
      std::size_t expected = 0;
      for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x)
          if (rounded_rectangle_covers(corners, place_in({x, y}, within), ties)) ++expected;
      EXPECT_EQ(pixels.size(), expected);
      covered += pixels.size();
    }
  }
  EXPECT_GT(covered, 1000u);
}

TEST(SnappedRectangle, WhatIsRoundedAwayHoldsNothing) {
  const TieRule& closed = *find_tie_rule("closed");
  const Segment dot{at(1, 1), at(1 + 1 / 65536.0, 1)};
  const auto corners = rounded_corners(dot, Fixed::from_integer(1), RectangleRounding::corners);
  EXPECT_EQ(corners[0], corners[1]);
  EXPECT_FALSE(rounded_rectangle_covers(corners, at(1, 1), closed));
}

// The smallest triangle there is: two corners have met, and the side between them decides nothing.
TEST(SnappedRectangle, ASideThatIsRoundedAwayDecidesNothing) {
  const auto raw = [](std::int64_t x, std::int64_t y) -> Point {
    return {Fixed::from_raw(x), Fixed::from_raw(y)};
  };
  const std::array corners = {raw(0, 0), raw(1, 0), raw(0, 1), raw(0, 1)};
  EXPECT_TRUE(rounded_rectangle_covers(corners, raw(0, 0), *find_tie_rule("left-bottom")));
  EXPECT_FALSE(rounded_rectangle_covers(corners, raw(0, 1), *find_tie_rule("left-bottom")));
  EXPECT_TRUE(rounded_rectangle_covers(corners, raw(0, 1), *find_tie_rule("closed")));
}

// Each corner alone may be the one that reaches across a border, to either side.
TEST(SnappedRectangle, AnyCornerCrossesABorder) {
  for (std::size_t far = 0; far < 4; ++far)
    for (const double to : {-0.5, 1.5})
      for (const bool level : {true, false}) {
        std::array<Point, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i) {
          const double along = i == far ? to : 0.5, across = i % 2 == 0 ? 0.5 : 1.5;
          corners[i] = level ? at(along, across) : at(across, along);
        }
        EXPECT_TRUE(crosses_borders(corners, {0, 0, 2, 2})) << far << ' ' << to;
        corners[far] = level ? at(0.75, 1.5) : at(1.5, 0.75);
        EXPECT_FALSE(crosses_borders(corners, {0, 0, 2, 2})) << far << ' ' << to;
      }
}

}  // namespace
}  // namespace edgecase
