// SPDX-License-Identifier: MIT
//
// line.multisampled: the rectangle of quotients against that of multiples of 2^-16, and ruling 28
// against moves of the ends that are really made.
#include "rules/samples/multisampled_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "model/sampling.h"
#include "rules/coverage/line_areas.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

class Random {
 public:
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(engine_);
  }
  // From -1 to 4 pixels, in steps.
  Point point(std::int64_t step) {
    const auto one = [&] {
      return Fixed::from_raw(between(-Fixed::kOne / step, 4 * Fixed::kOne / step) * step);
    };
    const Fixed x = one();
    return {x, one()};
  }

 private:
  std::mt19937_64 engine_{5};
};

Point sum(Point p, std::int64_t dx, std::int64_t dy) {
  return {p.x + Fixed::from_raw(dx), p.y + Fixed::from_raw(dy)};
}

TEST(MultisampledLine, QuotientsAreTheLineThatTheyAre) {
  Random random;
  int covered = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::int64_t step = Fixed::kOne >> random.between(1, 4);
    const Segment segment{random.point(step), random.point(step)};
    const Point sample = random.point(step);
    const Fixed width = Fixed::from_raw(random.between(1, 24) * Fixed::kOne / 8);
    const std::int64_t w = random.between(1, 1 << 15);
    HomogeneousSegment quotients{homogeneous(segment.a), homogeneous(segment.b)};
    for (std::int64_t* part : {&quotients.b.x, &quotients.b.y, &quotients.b.w}) *part *= w;
    for (const char* name : {"left-top", "bottom-right", "open", "closed"}) {
      const TieRule& ties = *find_tie_rule(name);
      const bool expected = line_area_covers(segment, width, LineArea::rectangle, sample, ties);
      EXPECT_EQ(multisampled_line_covers(quotients, width, sample, ties), expected);
      covered += expected ? 1 : 0;
    }
  }
  EXPECT_GT(covered, 2000);
}

TEST(MultisampledLine, TheSearchMissesNothing) {
  Random random;
  const PixelBounds target{0, 0, 5, 5};
  const TieRule& ties = *find_tie_rule("closed");
  for (int round = 0; round < 300; ++round) {
    const HomogeneousSegment segment{{random.between(-9, 21), random.between(-9, 21), 3},
                                     {random.between(-21, 49), random.between(-21, 49), 7}};
    const Point within{Fixed::from_raw(random.between(0, 15) * 4096),
                       Fixed::from_raw(random.between(0, 15) * 4096)};
    const Fixed width = Fixed::from_raw(random.between(1, 24) * Fixed::kOne / 4);
    std::vector<PixelPosition> expected;
    for (int x = 0; x <= 5; ++x)
      for (int y = 0; y <= 5; ++y)
        if (multisampled_line_covers(segment, width, place_in({x, y}, within), ties))
          expected.push_back({x, y});
    auto found = multisampled_line_pixels(segment, width, target, within, ties);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected) << round;
  }
}

// Where one end rounds to the place of the other, the line is still as wide as it is.
TEST(MultisampledLine, ShorterThanASixtyFourThousandth) {
  const HomogeneousSegment segment{
      {5, 5, 2}, {(std::int64_t{5} << 30) + 1, std::int64_t{5} << 30, std::int64_t{2} << 30}};
  const auto pixels = multisampled_line_pixels(segment, Fixed::from_integer(3), {0, 0, 4, 4},
                                               centre_of_pixel(), *find_tie_rule("closed"));
  EXPECT_EQ(pixels.size(), 3u);  // a column of three
}

// Moves of both ends by less than the reach never yield what ruling 28 denies; and what it allows
// some move or tie yields, but for a few samples.
TEST(MultisampledLine, LatitudeHoldsWhatMovesYield) {
  Random random;
  const TieRule& open = *find_tie_rule("open");
  const TieRule& closed = *find_tie_rule("closed");
  int denied_cover = 0, denied_leave = 0, allowed_both = 0, seen_both = 0;
  for (int round = 0; round < 6000; ++round) {
    const Fixed reach = Fixed::from_raw(Fixed::kOne >> random.between(0, 8));
    const Segment segment{random.point(4096), random.point(4096)};
    const Fixed width = Fixed::from_raw(random.between(1, 24) * Fixed::kOne / 8);
    const Point sample = random.point(4096);
    bool covered = false;
    bool uncovered = false;
    // The corners of the moves, and places between.
    const std::int64_t most = reach.raw() - 1;
    for (int move = 0; move < 625; ++move) {
      const auto part = [&](int by) { return (move / by % 5 - 2) * most / 2; };
      const Segment moved{sum(segment.a, part(1), part(5)), sum(segment.b, part(25), part(125))};
      covered = covered || line_area_covers(moved, width, LineArea::rectangle, sample, closed);
      uncovered = uncovered || !line_area_covers(moved, width, LineArea::rectangle, sample, open);
    }
    const bool may_cover = multisampled_line_possibly_covered(segment, width, sample, reach);
    const bool may_leave = multisampled_line_possibly_uncovered(segment, width, sample, reach);
    EXPECT_TRUE(may_cover || !covered) << round;
    EXPECT_TRUE(may_leave || !uncovered) << round;
    denied_cover += may_cover ? 0 : 1;
    denied_leave += may_leave ? 0 : 1;
    if (reach > Fixed::from_raw(Fixed::kOne / 16)) continue;
    allowed_both += may_cover && may_leave ? 1 : 0;
    seen_both += covered && uncovered ? 1 : 0;
  }
  EXPECT_GT(denied_cover, 1000);
  EXPECT_GT(denied_leave, 200);
  EXPECT_GT(seen_both, 50);
  // Sides are taken as though they moved independently: that is little more.
  EXPECT_LT(allowed_both, seen_both * 5 / 4);
}

TEST(MultisampledLine, WithoutReachTheBoundaryAloneIsOpen) {
  const Segment segment{at(1, 1), at(3, 1)};
  const Fixed width = Fixed::from_integer(1);
  const auto allowed = [&](double x, double y) {
    return std::pair{multisampled_line_possibly_covered(segment, width, at(x, y), Fixed()),
                     multisampled_line_possibly_uncovered(segment, width, at(x, y), Fixed())};
  };
  constexpr double kUnit = 1.0 / 65536;
  EXPECT_EQ(allowed(2, 1.5), (std::pair{true, true}));
  EXPECT_EQ(allowed(2, 1.5 - kUnit), (std::pair{true, false}));
  EXPECT_EQ(allowed(2, 1.5 + kUnit), (std::pair{false, true}));
  EXPECT_EQ(allowed(1, 1), (std::pair{true, true}));
  EXPECT_EQ(allowed(1 + kUnit, 1), (std::pair{true, false}));
  EXPECT_EQ(allowed(1 - kUnit, 1), (std::pair{false, true}));
  EXPECT_EQ(allowed(3, 0.5), (std::pair{true, true}));
  EXPECT_EQ(allowed(3 + kUnit, 0.5), (std::pair{false, true}));
  EXPECT_FALSE(multisampled_line_possibly_covered({at(2, 2), at(2, 2)}, width, at(2, 2), Fixed()));
  EXPECT_TRUE(multisampled_line_possibly_uncovered({at(2, 2), at(2, 2)}, width, at(2, 2), Fixed()));
}

// The ends of the range, for which the bounds of the products are made.
TEST(MultisampledLine, LatitudeAcrossTheWholeRange) {
  const Segment diagonal{at(-8192, -8192), at(8192, 8192)};
  const Fixed width = Fixed::from_integer(64);
  const Fixed reach = Fixed::from_integer(1);
  EXPECT_FALSE(multisampled_line_possibly_uncovered(diagonal, width, at(4096, 4096), reach));
  EXPECT_TRUE(multisampled_line_possibly_covered(diagonal, width, at(4096, 4096 + 45), reach));
  EXPECT_FALSE(multisampled_line_possibly_covered(diagonal, width, at(4096, 4096 + 49), reach));
  EXPECT_FALSE(multisampled_line_possibly_uncovered(diagonal, width, at(4096, 4096 - 42), reach));
  EXPECT_FALSE(multisampled_line_possibly_covered(diagonal, width, at(8191, -8191), reach));
}

TEST(MultisampledLine, NamesAreReadBack) {
  for (MultisampledLine line : values_of<MultisampledLine>()) {
    MultisampledLine read = MultisampledLine::rectangle;
    EXPECT_TRUE(parse_name(name_of(line), read));
    EXPECT_EQ(read, line);
  }
  MultisampledLine read = MultisampledLine::parallelogram;
  EXPECT_FALSE(parse_name("capsule", read));
  EXPECT_EQ(read, MultisampledLine::parallelogram);
}

}  // namespace
}  // namespace edgecase
