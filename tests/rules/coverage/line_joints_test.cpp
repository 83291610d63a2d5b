// SPDX-License-Identifier: MIT
//
// Ruling 14, transcribed once more and literally: every pixel and every column is asked by itself,
// by the diamonds of tests/oracles. Held against our predicate on right, damaged and random lines;
// and each clause broken by a drawn example.
#include "rules/coverage/line_joints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "rules/coverage/diamond_exit.h"
#include "tests/oracles/diamonds.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

constexpr PixelBounds kTarget{0, 0, 15, 15};

const DiamondBoundary& standard() {
  return *find_diamond_boundary("left-bottom");
}

Pixels exact(const Segment& segment, const PixelBounds& bounds = kTarget) {
  return diamond_exit_pixels(segment, bounds, standard());
}

std::string broken(const Segment& first, const Pixels& of_first, const Segment& second,
                   const Pixels& of_second, const PixelBounds& bounds = kTarget) {
  return broken_joint_clause({first, of_first, bounds}, {}, {second, of_second, bounds});
}

// The oracle. A line, what was drawn of it, and which way it goes: 1 right, -1 left, 2 up, -2 down.
struct Drawn {
  Segment segment;
  Pixels pixels;
};

int way(const Segment& s) {
  const std::int64_t dx = s.b.x.raw() - s.a.x.raw();
  const std::int64_t dy = s.b.y.raw() - s.a.y.raw();
  if (dx == 0 && dy == 0) return 0;
  if (std::abs(dy) > std::abs(dx)) return dy > 0 ? 2 : -2;
  return dx > 0 ? 1 : -1;
}

oracle::Spot spot(Point p) {
  return {oracle::Rational(p.x.raw(), Fixed::kOne), oracle::Rational(p.y.raw(), Fixed::kOne)};
}

int column_of(PixelPosition p, int way) {
  return std::abs(way) == 1 ? p.x : p.y;
}

bool in_column(const Pixels& pixels, int column, int way) {
  return std::any_of(pixels.begin(), pixels.end(),
                     [&](PixelPosition p) { return column_of(p, way) == column; });
}

// Has the rule a fragment in a column, one unit or more inside the border?
bool shows_in_column(const Segment& segment, int column, int way, const PixelBounds& bounds) {
  const oracle::Boundary boundary = oracle::boundary_named("left-bottom");
  for (int y = bounds.y_min + 1; y <= bounds.y_max - 1; ++y)
    for (int x = bounds.x_min + 1; x <= bounds.x_max - 1; ++x)
      if (column_of({x, y}, way) == column &&
          oracle::exits_diamond({spot(segment.a), spot(segment.b)}, boundary, x, y))
        return true;
  return false;
}

// Has the rule a fragment in one of these columns, all of them where `columns` is empty, within one
// unit of the border or up to two beyond it?
bool hides(const Segment& segment, const std::vector<int>& columns, int way,
           const PixelBounds& bounds) {
  const oracle::Boundary boundary = oracle::boundary_named("left-bottom");
  const PixelBounds inside = bounds.grown(-1);
  for (int y = bounds.y_min - 2; y <= bounds.y_max + 2; ++y)
    for (int x = bounds.x_min - 2; x <= bounds.x_max + 2; ++x) {
      const bool is_asked = columns.empty() || std::find(columns.begin(), columns.end(),
                                                         column_of({x, y}, way)) != columns.end();
      if (is_asked && !inside.contains({x, y}) &&
          oracle::exits_diamond({spot(segment.a), spot(segment.b)}, boundary, x, y))
        return true;
    }
  return false;
}

bool oracle_breaks(const Drawn& first, const std::vector<Segment>& between, const Drawn& second,
                   const PixelBounds& bounds) {
  const int go = way(first.segment);
  // A segment between of which the border may hide something is not passed over.
  for (const Segment& segment : between)
    if (hides(segment, {}, go, bounds)) return false;
  // No pixel is drawn by both.
  for (PixelPosition p : first.pixels)
    for (PixelPosition q : second.pixels)
      if (p == q) return true;
  // None between their fragments is empty.
  std::vector<Segment> all = between;
  all.push_back(first.segment);
  all.push_back(second.segment);
  const int step = go > 0 ? 1 : -1;
  int last = column_of(first.pixels.front(), go);
  for (PixelPosition p : first.pixels)
    if ((column_of(p, go) - last) * step > 0) last = column_of(p, go);
  int next = column_of(second.pixels.front(), go);
  for (PixelPosition p : second.pixels)
    if ((next - column_of(p, go)) * step > 0) next = column_of(p, go);
  for (int column = last + step; (next - column) * step > 0; column += step)
    for (const Segment& segment : all)
      if (shows_in_column(segment, column, go, bounds)) return true;
  // The fragments next to the joint are at most one unit apart.
  if ((next - last) * step > 1) return false;
  std::vector<int> near;
  for (int column = std::min(last, next) - 1; column <= std::max(last, next) + 1; ++column)
    near.push_back(column);
  for (const Segment& segment : all)
    if (hides(segment, near, go, bounds)) return false;
  for (PixelPosition p : first.pixels)
    for (PixelPosition q : second.pixels)
      if (std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) <= 1) return false;
  return true;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  // On a grid of quarters, up to a pixel beyond the target.
  Point point(const PixelBounds& bounds) {
    const auto one = [&](int low, int high) { return low - 1 + below(4 * (high - low + 3)) / 4.; };
    return at(one(bounds.x_min, bounds.x_max), one(bounds.y_min, bounds.y_max));
  }
  // Some pixels moved, some left out; at most one in a column, as ruling 1 has it.
  Pixels damaged(Pixels pixels, int way) {
    for (PixelPosition& p : pixels)
      if (below(4) == 0) p = {p.x + below(3) - 1, p.y + below(3) - 1};
    std::erase_if(pixels, [&](PixelPosition) { return below(6) == 0; });
    Pixels result;
    for (PixelPosition p : pixels)
      if (!in_column(result, column_of(p, way), way)) result.push_back(p);
    std::shuffle(result.begin(), result.end(), engine_);
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

TEST(LineJoint, OracleAndPredicateAgreeOnDamagedLines) {
  constexpr PixelBounds kSmall{0, 0, 6, 5};
  Random random(7);
  int joints = 0;
  int broken_ones = 0;
  while (joints < 20000) {
    const Point a = random.point(kSmall), b = random.point(kSmall), c = random.point(kSmall),
                d = random.point(kSmall);
    const bool middle = random.below(3) == 0;
    const Segment first{a, b};
    const Segment second = middle ? Segment{c, d} : Segment{b, c};
    std::vector<Segment> between;
    if (middle) between.push_back({b, c});
    const bool one_way =
        way(first) != 0 && way(first) == way(second) && (!middle || way(between[0]) == way(first));
    EXPECT_EQ(!middle && one_way, goes_on(first, second) && !middle);
    if (!one_way) continue;
    const Drawn one{first, random.damaged(exact(first, kSmall), way(first))};
    const Drawn two{second, random.damaged(exact(second, kSmall), way(second))};
    if (one.pixels.empty() || two.pixels.empty()) continue;
    ++joints;
    const bool expected = oracle_breaks(one, between, two, kSmall);
    const std::string clause = broken_joint_clause({one.segment, one.pixels, kSmall}, between,
                                                   {two.segment, two.pixels, kSmall});
    ASSERT_EQ(!clause.empty(), expected) << joints << ": " << clause;
    broken_ones += expected ? 1 : 0;
  }
  EXPECT_GT(broken_ones, 4000);
  EXPECT_LT(broken_ones, 16000);
}

// Every three points of a grid of 9 by 9, in a target that cuts some of the lines, under every tie
// order: what the diamond-exit rule draws is never broken.
class ExactAtJoints : public ::testing::TestWithParam<int> {
 protected:
  // Four points: the middle draws nothing.
  void each_chain(const DiamondBoundary& boundary, const PixelBounds& bounds) {
    const int n = static_cast<int>(points_.size());
    std::vector<Pixels> drawn;
    for (Point a : points_)
      for (Point b : points_) drawn.push_back(diamond_exit_pixels({a, b}, bounds, boundary));
    const auto pixels = [&](int a, int b) -> const Pixels& {
      return drawn[static_cast<std::size_t>(a * n + b)];
    };
    const auto segment = [&](int a, int b) {
      return Segment{points_[static_cast<std::size_t>(a)], points_[static_cast<std::size_t>(b)]};
    };
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        if (pixels(a, b).empty()) continue;
        for (int c = 0; c < n; ++c) {
          if (!goes_on(segment(a, b), segment(b, c))) continue;
          if (!pixels(b, c).empty()) {
            expect_whole({segment(a, b), pixels(a, b)}, {}, {segment(b, c), pixels(b, c)}, bounds);
            continue;
          }
          for (int d = 0; d < n; ++d)
            if (goes_on(segment(b, c), segment(c, d)) && !pixels(c, d).empty()) {
              ++past_a_middle_;
              expect_whole({segment(a, b), pixels(a, b)}, {segment(b, c)},
                           {segment(c, d), pixels(c, d)}, bounds);
            }
        }
      }
  }

  void expect_whole(const Drawn& first, const std::vector<Segment>& between, const Drawn& second,
                    const PixelBounds& bounds) {
    ++joints_;
    const std::string clause = broken_joint_clause({first.segment, first.pixels, bounds}, between,
                                                   {second.segment, second.pixels, bounds});
    if (!clause.empty() && faults_++ == 0) ADD_FAILURE() << clause;
  }

  const std::vector<Point> points_ = [] {
    std::vector<Point> points;
    const double step = GetParam() / 4.;
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 7; ++x) points.push_back(at(x * step, y * step));
    return points;
  }();
  long joints_ = 0;
  long past_a_middle_ = 0;
  long faults_ = 0;
};

TEST_P(ExactAtJoints, AreWhole) {
  for (const DiamondBoundary& boundary : all_diamond_boundaries()) {
    const TieRule* ties = find_tie_rule(boundary.name);
    if (ties == nullptr || ties->kind != TieRule::Kind::perturbed) continue;
    // The whole, and targets whose border the lines leave and cross.
    for (const PixelBounds& bounds :
         {PixelBounds{-2, -2, 6, 6}, PixelBounds{0, 0, 1, 1}, PixelBounds{1, 0, 1, 3}})
      each_chain(boundary, bounds);
  }
  EXPECT_GT(joints_, 20000);
  EXPECT_GT(past_a_middle_, 1000);
  EXPECT_EQ(faults_, 0) << "of " << joints_;
  std::printf("%ld joints, %ld of them past a middle that draws nothing\n", joints_,
              past_a_middle_);
}

INSTANTIATE_TEST_SUITE_P(Grids, ExactAtJoints, ::testing::Values(1, 2));

// Drawn examples. The joint lies at a pixel's centre.
const Segment kFirst{at(2.5, 5.5), at(7.5, 6.5)};
const Segment kSecond{at(7.5, 6.5), at(12.5, 7.5)};
const Segment kUp{at(5.5, 2.5), at(6.5, 7.5)};
const Segment kOnUp{at(6.5, 7.5), at(6.5, 12.5)};

TEST(LineJoint, WhatTheRuleDrawsIsWhole) {
  EXPECT_EQ(broken(kFirst, exact(kFirst), kSecond, exact(kSecond)), "");
  EXPECT_EQ(broken(kUp, exact(kUp), kOnUp, exact(kOnUp)), "");
}

TEST(LineJoint, APixelDrawnByBoth) {
  Pixels first = exact(kFirst);
  first.push_back({7, 6});
  EXPECT_EQ(broken(kFirst, first, kSecond, exact(kSecond)),
            "pixel (7, 6) is drawn by both segments of a joint");
}

// Two fragments side by side in one column, one of each segment, interrupt nothing.
TEST(LineJoint, AColumnWithAFragmentOfEach) {
  Pixels first = exact(kFirst);
  first.push_back({7, 7});
  EXPECT_EQ(broken(kFirst, first, kSecond, exact(kSecond)), "");
  Pixels up = exact(kUp);
  up.push_back({7, 7});
  EXPECT_EQ(broken(kUp, up, kOnUp, exact(kOnUp)), "");
}

TEST(LineJoint, AnEmptyColumnBetween) {
  Pixels second = exact(kSecond);
  std::erase(second, PixelPosition{7, 6});
  EXPECT_EQ(broken(kFirst, exact(kFirst), kSecond, second),
            "column 7 is empty between the two segments of a joint");
  const Segment back{kSecond.b, kSecond.a}, on_back{kFirst.b, kFirst.a};
  Pixels leftward = exact(back);
  std::erase_if(leftward, [](PixelPosition p) { return p.x == 8; });
  EXPECT_EQ(broken(back, leftward, on_back, exact(on_back)),
            "column 8 is empty between the two segments of a joint");
}

TEST(LineJoint, FragmentsApart) {
  Pixels first = exact(kFirst);
  Pixels second = exact(kSecond);
  for (PixelPosition& p : first) --p.y;
  for (PixelPosition& p : second) ++p.y;
  EXPECT_EQ(broken(kFirst, first, kSecond, second),
            "the fragments of columns 6 and 7, where a joint lies, are more than one apart");
}

// What the border may hide is not missing: the joint lies in the target's outermost column.
TEST(LineJoint, AnEmptyColumnAtTheBorderIsNotHeldAgainstIt) {
  const auto without_column_seven = [](Pixels pixels) {
    std::erase_if(pixels, [](PixelPosition p) { return p.x == 7; });
    return pixels;
  };
  const auto gap_in = [&](const PixelBounds& bounds) {
    return broken(kFirst, exact(kFirst, bounds), kSecond,
                  without_column_seven(exact(kSecond, bounds)), bounds);
  };
  EXPECT_NE(gap_in({0, 0, 15, 15}), "");
  EXPECT_NE(gap_in({0, 5, 15, 15}), "") << "row 6 lies one inside";
  EXPECT_EQ(gap_in({0, 6, 15, 15}), "") << "row 6 is the lowest";
  EXPECT_NE(gap_in({0, 0, 15, 7}), "");
  EXPECT_EQ(gap_in({0, 0, 15, 6}), "") << "row 6 is the highest";
}

// Draws' scissors may differ: what counts is what both may draw.
TEST(LineJoint, TheBordersOfBothSegmentsCount) {
  Pixels second = exact(kSecond);
  std::erase(second, PixelPosition{7, 6});
  const Pixels first = exact(kFirst);
  const auto clause = [&](const PixelBounds& of_first, const PixelBounds& of_second) {
    return broken_joint_clause({kFirst, first, of_first}, {}, {kSecond, second, of_second});
  };
  EXPECT_NE(clause(kTarget, kTarget), "");
  // Pixel (7, 6) lies in the outermost row or column of one of them.
  for (const PixelBounds& narrow : {PixelBounds{7, 0, 15, 15}, PixelBounds{0, 6, 15, 15},
                                    PixelBounds{0, 0, 7, 15}, PixelBounds{0, 0, 15, 6}}) {
    EXPECT_EQ(clause(kTarget, narrow), "");
    EXPECT_EQ(clause(narrow, kTarget), "");
  }
}

TEST(LineJoint, AMiddleThatShouldHaveDrawnIsAGap) {
  const Segment middle{at(7.5, 6.5), at(9.5, 6.75)}, last{at(9.5, 6.75), at(13.5, 7.5)};
  const Pixels before = exact(kFirst), after = exact(last);
  EXPECT_EQ(
      broken_joint_clause({kFirst, before, kTarget}, std::span(&middle, 1), {last, after, kTarget}),
      "column 7 is empty between the two segments of a joint");
}

TEST(LineJoint, GoesOnOnlyInOneDirection) {
  const Segment right{at(2, 2), at(6, 3)}, up{at(6, 3), at(7, 8)}, left{at(6, 3), at(2, 4)},
      down{at(6, 3), at(7, -4)}, diagonal{at(6, 3), at(9, 6)}, falling{at(6, 3), at(9, 0)},
      nothing{at(6, 3), at(6, 3)}, elsewhere{at(6, 3.25), at(9, 3)};
  EXPECT_TRUE(goes_on(right, diagonal)) << "45 degrees is x-major";
  EXPECT_TRUE(goes_on(right, falling));
  EXPECT_FALSE(goes_on(right, up));
  EXPECT_FALSE(goes_on(right, down));
  EXPECT_FALSE(goes_on(right, left));
  EXPECT_FALSE(goes_on(right, nothing));
  EXPECT_FALSE(goes_on(nothing, diagonal));
  EXPECT_FALSE(goes_on(right, elsewhere));
  EXPECT_FALSE(goes_on(right, right)) << "starts at one point";
  EXPECT_TRUE(goes_on({up.b, up.a}, {at(6, 3), at(5, -1)}));
  EXPECT_FALSE(goes_on({up.b, up.a}, {at(6, 3), at(2, -1)})) << "diagonal";
}

// A segment between that the target's border may hide is no gap: what is drawn of its neighbours
// need not meet. One that lies inside, and of which nothing was drawn, is.
TEST(LineJoints, ASegmentThatTheBorderMayHideIsNotPassedOver) {
  const auto clause_at = [](double y) {
    const Segment down{at(1.5, y + 2), at(3.5, y)};
    const Segment level{at(3.5, y), at(6.5, y)};
    const Segment up{at(6.5, y), at(8.5, y + 2)};
    // All of them a unit lower, and nothing of what would lie below the target.
    const auto lowered = [](const Segment& segment) {
      Pixels pixels;
      for (PixelPosition p : exact(segment))
        if (p.y > 0) pixels.push_back({p.x, p.y - 1});
      return pixels;
    };
    const Pixels of_down = lowered(down), of_up = lowered(up);
    return broken_joint_clause({down, of_down, kTarget}, std::vector{level}, {up, of_up, kTarget});
  };
  EXPECT_EQ(clause_at(0.5), "");
  EXPECT_NE(clause_at(2.5), "");
}

}  // namespace
}  // namespace edgecase
