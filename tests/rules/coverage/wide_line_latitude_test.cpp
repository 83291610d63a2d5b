// SPDX-License-Identifier: MIT
//
// Ruling 12 against right and deliberately wrong wide lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_latitude.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

constexpr PixelBounds kTarget{0, 0, 15, 15};
constexpr int kWidth = 3;
const Segment kShallow{at(2.5, 5.5), at(10.5, 8.5)};
const Segment kSteep{at(5.5, 2.5), at(8.5, 10.5)};

Pixels exact(const Segment& segment, int width = kWidth, const PixelBounds& bounds = kTarget) {
  LineChoice choice;
  choice.boundary = find_diamond_boundary("left-bottom");
  return line_pixels(segment, Fixed::from_integer(width), bounds, choice,
                     *find_tie_rule("left-top"));
}

std::string broken(const Segment& segment, const Pixels& drawn, int width = kWidth,
                   const PixelBounds& bounds = kTarget) {
  return broken_line_clause({segment, width, bounds}, drawn);
}

// The pixels without those of one column.
Pixels without_column(Pixels pixels, int x) {
  std::erase_if(pixels, [&](PixelPosition p) { return p.x == x; });
  return pixels;
}

Pixels shifted(Pixels pixels, int x, int y) {
  for (PixelPosition& p : pixels) p = {p.x + x, p.y + y};
  return pixels;
}

TEST(WideLineLatitude, ExactIsLegal) {
  for (const Segment& segment : {kShallow, kSteep})
    for (int width : {2, 3, 4, 7}) EXPECT_EQ(broken(segment, exact(segment, width), width), "");
}

TEST(WideLineLatitude, OneUnitIsLegalTwoAreNot) {
  for (const Segment& segment : {kShallow, kSteep}) {
    EXPECT_EQ(broken(segment, shifted(exact(segment), 1, 0)), "");
    EXPECT_EQ(broken(segment, shifted(exact(segment), 0, 1)), "");
    EXPECT_NE(broken(segment, shifted(exact(segment), 2, 0)), "");
    EXPECT_NE(broken(segment, shifted(exact(segment), 0, 2)), "");
    EXPECT_NE(broken(segment, shifted(exact(segment), 0, -2)), "");
  }
}

TEST(WideLineLatitude, OneColumnMoreOrLessIsLegalTwoAreNot) {
  EXPECT_EQ(broken(kShallow, without_column(exact(kShallow), 2)), "");
  EXPECT_EQ(broken(kShallow, without_column(exact(kShallow), 5)), "");
  EXPECT_NE(broken(kShallow, without_column(without_column(exact(kShallow), 2), 3)), "");
  EXPECT_NE(broken(kShallow, {}), "");
}

TEST(WideLineLatitude, AColumnThatLacksAFragmentIsIllegal) {
  for (std::size_t which : {0u, 1u, 2u}) {
    Pixels pixels = exact(kShallow);
    std::sort(pixels.begin(), pixels.end());
    pixels.erase(pixels.begin() + static_cast<long>(which));
    EXPECT_EQ(broken(kShallow, pixels), "column 2 holds 2 fragments, not one run of 3") << which;
  }
}

TEST(WideLineLatitude, ARowOfASteepLineThatLacksAFragmentIsIllegal) {
  Pixels pixels = exact(kSteep);
  std::sort(pixels.begin(), pixels.end(),
            [](PixelPosition a, PixelPosition b) { return a.y < b.y; });
  pixels.erase(pixels.begin());
  EXPECT_EQ(broken(kSteep, pixels), "row 2 holds 2 fragments, not one run of 3");
}

TEST(WideLineLatitude, TwoRunsInAColumnAreIllegal) {
  // The top fragment of a run of three one row higher: as many fragments, with a gap.
  Pixels pixels = exact(kShallow);
  const auto top = std::max_element(pixels.begin(), pixels.end(), [](auto a, auto b) {
    return a.x != 2 ? b.x == 2 : b.x == 2 && a.y < b.y;
  });
  ++top->y;
  EXPECT_EQ(broken(kShallow, pixels), "column 2 holds 3 fragments, not one run of 3");
}

TEST(WideLineLatitude, AColumnThatIsTooHighIsIllegal) {
  Pixels pixels = exact(kShallow);
  std::sort(pixels.begin(), pixels.end());
  pixels.push_back({2, pixels[2].y + 1});
  EXPECT_EQ(broken(kShallow, pixels), "column 2 holds 4 fragments, not one run of 3");
}

TEST(WideLineLatitude, AFragmentThatComesTwiceIsIllegal) {
  Pixels pixels = exact(kShallow);
  pixels.push_back(pixels.front());
  EXPECT_NE(broken(kShallow, pixels), "");
}

TEST(WideLineLatitude, WhatTheBorderCutsGoesOnBeyondIt) {
  // Row 0 is the line's own: of its three rows one lies below the target, and one above.
  const Segment low{at(2.5, 0.5), at(10.5, 0.5)};
  const Segment high{at(2.5, 15.5), at(10.5, 15.5)};
  for (const Segment& segment : {low, high}) {
    EXPECT_EQ(exact(segment).size(), 16u);
    EXPECT_EQ(broken(segment, exact(segment)), "");
  }
  // One row less is one row lower, which is legal; none at all is not.
  const auto row = [](int y) {
    Pixels pixels;
    for (int x = 2; x < 10; ++x) pixels.push_back({x, y});
    return pixels;
  };
  EXPECT_EQ(broken(low, row(0)), "");
  EXPECT_NE(broken(low, {}), "");
  EXPECT_EQ(broken(high, row(15)), "");
  // A row that does not lie at the border is not cut by it.
  EXPECT_NE(broken(low, row(1)), "");
  EXPECT_NE(broken(high, row(14)), "");
}

TEST(WideLineLatitude, ATargetThatIsLowerThanTheLineIsHigh) {
  // Both borders cut the line: what is seen fits, wherever the runs begin.
  const PixelBounds strip{0, 0, 15, 3};
  const Segment segment{at(2.5, 2), at(10.5, 1)};
  EXPECT_EQ(exact(segment, 9, strip).size(), 8u * 4);
  EXPECT_EQ(broken(segment, exact(segment, 9, strip), 9, strip), "");
  const Pixels gap = without_column(exact(segment, 9, strip), 4);
  EXPECT_EQ(broken(segment, gap, 9, strip), "");
  EXPECT_NE(broken(segment, without_column(gap, 5), 9, strip), "");
  EXPECT_NE(broken(segment, {}, 9, strip), "");
}

// What the rule itself draws is legal, however little of it is seen.
TEST(WideLineLatitude, ExactIsLegalInEveryWindow) {
  std::mt19937_64 engine(20260601);
  const auto up_to = [&](std::uint64_t last) { return static_cast<int>(engine() % (last + 1)); };
  for (int i = 0; i < 100'000; ++i) {
    const double step = i % 2 == 0 ? 0.25 : 1.0 / 65536;
    const auto coordinate = [&] { return step * up_to(static_cast<std::uint64_t>(8 / step)); };
    const Segment segment{at(coordinate(), coordinate()), at(coordinate(), coordinate())};
    const int width = 1 + up_to(6);
    const int x = up_to(7);
    const int y = up_to(7);
    const PixelBounds window{x, y, x + up_to(4), y + up_to(4)};
    ASSERT_EQ(broken(segment, exact(segment, width, window), width, window), "")
        << segment.a.x.to_double() << " " << segment.a.y.to_double() << " to "
        << segment.b.x.to_double() << " " << segment.b.y.to_double() << " width " << width
        << " window " << window.x_min << " " << window.y_min << " " << window.x_max << " "
        << window.y_max;
  }
}

// Both borders of these windows cut every run, so that nothing seen tells where one begins.
TEST(WideLineLatitude, OneUnitIsLegalWhereBothBordersCut) {
  std::mt19937_64 engine(20261121);
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(engine() % static_cast<std::uint64_t>(high - low + 1));
  };
  int extra_columns = 0;
  for (int i = 0; i < 20'000; ++i) {
    // Rows (or columns) 10 to 12 of a line at least twelve wide that lies around them.
    const bool x_major = i % 2 == 0;
    const int width = between(12, 16);
    const auto along = [&] { return 0.25 * between(8, 80); };
    const auto across = [&] { return 11.5 + 0.25 * between(-12, 12); };
    const double a[] = {along(), across()}, b[] = {along(), across()};
    const auto point = [&](const double* p) { return x_major ? at(p[0], p[1]) : at(p[1], p[0]); };
    const Segment segment{point(a), point(b)};
    if (segment.x_major() != x_major) continue;
    const PixelBounds window = x_major ? PixelBounds{0, 10, 23, 12} : PixelBounds{10, 0, 12, 23};
    // The rule's own fragments, moved by up to one unit along both axes.
    const int dx = between(-1, 1), dy = between(-1, 1);
    Pixels drawn = shifted(exact(segment, width, window.grown(2)), dx, dy);
    std::erase_if(drawn, [&](PixelPosition p) { return !window.contains(p); });
    if (drawn.empty()) continue;
    extra_columns += (x_major ? dx : dy) != 0;
    ASSERT_EQ(broken(segment, drawn, width, window), "")
        << segment.a.x.to_double() << " " << segment.a.y.to_double() << " to "
        << segment.b.x.to_double() << " " << segment.b.y.to_double() << " width " << width
        << " moved " << dx << " " << dy;
  }
  EXPECT_GT(extra_columns, 5000);
}

}  // namespace
}  // namespace edgecase
