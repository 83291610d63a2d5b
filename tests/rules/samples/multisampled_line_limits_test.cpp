// SPDX-License-Identifier: MIT
//
// Ruling 28 at its very border, in units of 2^-16 pixels: what no move yields, but the next number
// would; and ties on the sides of a line of that width.
#include <gtest/gtest.h>

#include "rules/samples/multisampled_line.h"

#include "tests/support/points.h"

namespace edgecase {
namespace {

const Fixed kUnit = Fixed::from_raw(1);  // the reach
const Fixed kWide = Fixed::from_integer(64);

Segment run(std::int64_t x, std::int64_t y) {
  return {raw(0, 0), raw(x, y)};
}

bool may_cover(const Segment& segment, Fixed width, Point sample) {
  return multisampled_line_possibly_covered(segment, width, sample, kUnit);
}
bool may_leave(const Segment& segment, Fixed width, Point sample) {
  return multisampled_line_possibly_uncovered(segment, width, sample, kUnit);
}

// Of a level segment of length n a sample k before an end lies, as the ends move, at most
// (1 - k)(n - 2) + 2 products along it.
TEST(MultisampledLineLimits, BeforeTheEnds) {
  EXPECT_FALSE(may_cover(run(4, 0), kWide, raw(-2, 0)));  // 0
  EXPECT_FALSE(may_cover(run(4, 0), kWide, raw(6, 0)));
  EXPECT_TRUE(may_cover(run(3, 0), kWide, raw(-2, 0)));  // 1
  EXPECT_TRUE(may_cover(run(3, 0), kWide, raw(5, 0)));
}

// And one k behind the first end and j above the segment at least (k - 1)(n - 2) - 2 (j + 1).
TEST(MultisampledLineLimits, BetweenTheEnds) {
  EXPECT_FALSE(may_leave(run(4, 0), kWide, raw(2, 0)));  // 0, from either end
  EXPECT_TRUE(may_leave(run(5, 0), kWide, raw(2, 1)));   // -1 from the first
  EXPECT_TRUE(may_leave(run(5, 0), kWide, raw(3, 1)));   // -1 from the second
}

// Both ends can come to the sample, and leave no line.
TEST(MultisampledLineLimits, ALineThatMayVanish) {
  EXPECT_TRUE(may_leave(run(2, 2), kWide, raw(1, 1)));
  EXPECT_FALSE(may_leave(run(3, 3), kWide, raw(1, 1)) && may_leave(run(4, 4), kWide, raw(2, 2)));
}

TEST(MultisampledLineLimits, AtTheSides) {
  // Moved down by 1 all along, the line has the sample on its upper side.
  EXPECT_FALSE(may_leave(run(100, 0), Fixed::from_raw(8), raw(50, 3)));
  EXPECT_TRUE(may_leave(run(100, 0), Fixed::from_raw(7), raw(50, 3)));
  EXPECT_FALSE(may_leave(run(100, 0), Fixed::from_raw(8), raw(50, -3)));
  EXPECT_TRUE(may_leave(run(100, 0), Fixed::from_raw(7), raw(50, -3)));
  // Moved up by 1 and shortened to 2: (2^2 + 4^2) 8 is 4 times 5 times 2 times 4.
  EXPECT_FALSE(may_cover(run(4, 0), Fixed::from_raw(8), raw(2, 6)));
  EXPECT_TRUE(may_cover(run(4, 0), Fixed::from_raw(9), raw(2, 6)));
  // Moves bring the line as near as 1 product, on its one side and on the other.
  EXPECT_FALSE(may_cover(run(1, -3), kUnit, raw(3, 0)));
  EXPECT_FALSE(may_cover(run(1, -3), kUnit, raw(-2, -3)));
}

// A line from (0, 0) to (1, 0), in pixels, of which the sides are one unit off.
TEST(MultisampledLineLimits, TiesOfTheNarrowestSides) {
  const HomogeneousSegment segment{{0, 0, 1}, {1, 0, 1}};
  const auto covers = [&](const char* ties, std::int64_t y) {
    return multisampled_line_covers(segment, Fixed::from_raw(2), raw(Fixed::kOne / 2, y),
                                    *find_tie_rule(ties));
  };
  EXPECT_FALSE(covers("bottom-left", 1));
  EXPECT_TRUE(covers("bottom-left", 0));
  EXPECT_TRUE(covers("bottom-left", -1));
  EXPECT_TRUE(covers("top-left", 1));
  EXPECT_FALSE(covers("top-left", -1));
}

}  // namespace
}  // namespace edgecase
