// SPDX-License-Identifier: MIT
//
// Lines whose ends are known to within a reach: whatever the ends really are, what the rule draws
// of them lies between the certain and the possible fragments, and no ruling on lines convicts it.
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/loose_segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_joints.h"
#include "tests/support/points.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr PixelBounds kTarget{0, 0, 7, 7};

// Loose segments on the grid of 1/8, some of them beyond the target, and places of their ends.
class LooseSegments {
 public:
  LooseSegment next() {
    constexpr std::int64_t kReaches[] = {1, 2, 100, 1024, 4096, 12000, 24575};
    return {{point(), point()}, Fixed::from_raw(kReaches[between(0, 6)])};
  }
  Segment placed(const LooseSegment& loose) {
    return {placed(loose.segment.a, loose.reach), placed(loose.segment.b, loose.reach)};
  }
  Point placed(Point p, Fixed reach) { return {p.x + move(reach), p.y + move(reach)}; }
  Point point() {
    return {Fixed::from_raw(between(-8, 72) * Fixed::kOne / 8),
            Fixed::from_raw(between(-8, 72) * Fixed::kOne / 8)};
  }
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }

 private:
  // Often as far as it may be.
  Fixed move(Fixed reach) {
    if (between(0, 2) != 0) return Fixed::from_raw(reach.raw() * between(-1, 1));
    return Fixed::from_raw(between(-reach.raw(), reach.raw()));
  }
  std::mt19937_64 random_{share_seed(3)};
};

std::vector<PixelPosition> drawn(const Segment& segment, Fixed width, const PixelBounds& bounds) {
  return line_pixels(
      segment, width, bounds,
      {LineAlgorithm::diamond_exit, find_diamond_boundary("left-bottom"), WideLine::replicate},
      *find_tie_rule("left-top"));
}

const Fixed kOnePixel = Fixed::from_integer(1);

TEST(DiamondReach, HoldsWhatTheRuleDrawsForEveryPlaceOfTheEnds) {
  LooseSegments random;
  long open = 0;
  for (int round = 0; round < 200000; ++round) {
    const LooseSegment loose = random.next();
    const Segment placed = random.placed(loose);
    const auto exact = sorted(drawn(placed, kOnePixel, kTarget));
    const auto possible = sorted(possible_pixels(loose, kTarget));
    const auto certain = sorted(certain_pixels(loose, kTarget));
    ASSERT_TRUE(std::includes(possible.begin(), possible.end(), exact.begin(), exact.end()));
    ASSERT_TRUE(std::includes(exact.begin(), exact.end(), certain.begin(), certain.end()));
    open += possible != certain ? 1 : 0;
    ASSERT_TRUE(!surely_x_major(loose) || placed.x_major());
    ASSERT_TRUE(!surely_y_major(loose) || !placed.x_major());
    const PixelPosition at{static_cast<int>(random.between(0, 7)),
                           static_cast<int>(random.between(0, 7))};
    ASSERT_TRUE(!meets_diamond(placed, at.x, at.y, *find_diamond_boundary("closed")) ||
                may_meet_diamond(loose, at));
  }
  EXPECT_GT(open, 10000);
}

TEST(DiamondReach, IsTheRuleWhereTheEndsAreKnown) {
  LooseSegments random;
  for (int round = 0; round < 20000; ++round) {
    const LooseSegment known{random.next().segment, {}};
    const auto exact = drawn(known.segment, kOnePixel, kTarget);
    ASSERT_EQ(possible_pixels(known, kTarget), exact);
    ASSERT_EQ(certain_pixels(known, kTarget), exact);
    ASSERT_EQ(surely_x_major(known), known.segment.x_major());
    ASSERT_NE(surely_x_major(known), surely_y_major(known));
  }
}

// A reach opens what lies within it of a change, and nothing else.
TEST(DiamondReach, OpensOnlyWhatIsNear) {
  const Fixed reach = Fixed::from_raw(Fixed::kOne / 16);
  // Well inside every diamond, and well away from the next row's: nothing is open but the end.
  const LooseSegment plain{{at(0.5, 2.5), at(6.5, 2.75)}, reach};
  EXPECT_EQ(possible_pixels(plain, kTarget), certain_pixels(plain, kTarget));
  // An end less than two reaches from a diamond's corner opens that diamond and, two of its corners
  // being one, the next.
  const double unit = 1.0 / 65536;
  const auto open = [&](double x) {
    const LooseSegment loose{{at(0.5, 2.5), at(x, 2.5)}, reach};
    return possible_pixels(loose, kTarget).size() - certain_pixels(loose, kTarget).size();
  };
  EXPECT_EQ(open(4.125 + unit), 0u);
  EXPECT_EQ(open(4.125), 2u);
  EXPECT_EQ(open(3.875), 2u);
  EXPECT_EQ(open(3.875 - unit), 0u);
}

TEST(LineLatitude, ConvictsNoLineWhoseEndsErredWithinTheReach) {
  LooseSegments random;
  long needed = 0;
  for (int round = 0; round < share_of(60000); ++round) {
    const LooseSegment loose = random.next();
    const int width = static_cast<int>(random.between(1, 12));
    const auto pixels = drawn(random.placed(loose), Fixed::from_integer(width), kTarget);
    ASSERT_EQ(broken_line_clause({loose.segment, width, kTarget, loose.reach}, pixels), "")
        << round << " width " << width;
    needed += broken_line_clause({loose.segment, width, kTarget}, pixels).empty() ? 0 : 1;
  }
  EXPECT_GT(needed, least_of(900))
      << "without the reach some must be convicted, or this proves nothing";
}

TEST(LineLatitude, StillConvictsWhatNoPlaceOfTheEndsExplains) {
  const Segment segment{at(0.5, 2.5), at(6.5, 3.25)};
  const SeenLine line{segment, 1, kTarget, Fixed::from_raw(Fixed::kOne / 64)};
  auto pixels = drawn(segment, kOnePixel, kTarget);
  ASSERT_EQ(broken_line_clause(line, pixels), "");
  auto far = pixels;
  far.push_back({7, 7});
  EXPECT_EQ(broken_line_clause(line, far),
            "pixel (7, 7) has no diamond-exit fragment within one unit");
  auto crowded = pixels;
  crowded.push_back({1, 3});
  EXPECT_EQ(broken_line_clause(line, crowded), "column 1 holds two fragments of one segment");
  EXPECT_EQ(broken_line_clause(line, std::span(pixels).subspan(0, 2)),
            "2 fragments are drawn where the diamond-exit rule has 4 to 7 that may be seen; one "
            "more or less is allowed");
}

// Near 45 degrees a line may be read as x-major or as y-major.
TEST(LineLatitude, ReadsALineEitherWayWhoseMajorAxisIsOpen) {
  const Segment steep{at(1.5, 1.5), at(5.5, 5.5 + 1.0 / 64)};
  const std::vector<PixelPosition> twice_in_a_row = {{1, 1}, {2, 2}, {3, 3}, {4, 3}, {5, 4}};
  const auto clause = [&](double reach) {
    return broken_line_clause({steep, 1, kTarget, at(reach, 0).x}, twice_in_a_row);
  };
  EXPECT_EQ(clause(0), "row 3 holds two fragments of one segment");
  EXPECT_EQ(clause(1.0 / 512), "row 3 holds two fragments of one segment");
  EXPECT_EQ(clause(1.0 / 256), "");
}

TEST(LineJoints, ConvictNoTwoLinesWhoseEndsErredWithinTheReach) {
  LooseSegments random;
  long judged = 0;
  long needed = 0;
  for (int round = 0; round < 200000; ++round) {
    const LooseSegment loose = random.next();
    const Segment next{loose.segment.b, random.point()};
    if (!goes_on(loose.segment, next)) continue;
    const Segment first = random.placed(loose);
    const Segment second{first.b, random.placed(next.b, loose.reach)};
    const auto before = drawn(first, kOnePixel, kTarget);
    const auto after = drawn(second, kOnePixel, kTarget);
    if (before.empty() || after.empty()) continue;
    const auto clause = [&](Fixed reach) {
      return broken_joint_clause({loose.segment, before, kTarget}, {}, {next, after, kTarget},
                                 reach);
    };
    if (goes_on(loose.segment, next, loose.reach)) {
      ++judged;
      ASSERT_TRUE(goes_on(first, second));
      ASSERT_EQ(clause(loose.reach), "") << round;
    } else {
      needed += clause({}).empty() ? 0 : 1;
    }
  }
  EXPECT_GT(judged, 10000);
  EXPECT_GT(needed, 0) << "without the reach some must be convicted, or this proves nothing";
}

// Each end may move by the reach along both axes: the longer side loses two reaches where the
// shorter one gains two.
TEST(LooseSegment, IsMajorWhereFourReachesCannotTurnIt) {
  const Fixed reach = Fixed::from_raw(100);
  const auto along_x = [&](std::int64_t excess) {
    return LooseSegment{{at(1, 1), {at(5, 1).x + Fixed::from_raw(excess), at(1, 5).y}}, reach};
  };
  const auto along_y = [&](std::int64_t excess) {
    return LooseSegment{{at(1, 1), {at(5, 1).x, at(1, 5).y + Fixed::from_raw(excess)}}, reach};
  };
  EXPECT_TRUE(surely_x_major(along_x(400)));  // equal lengths are x-major
  EXPECT_FALSE(surely_x_major(along_x(399)));
  EXPECT_TRUE(surely_y_major(along_y(401)));
  EXPECT_FALSE(surely_y_major(along_y(400)));
}

}  // namespace
}  // namespace edgecase
