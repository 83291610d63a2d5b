// SPDX-License-Identifier: MIT
//
// Filters within a level: examples small enough to draw.
#include "rules/textures/texel_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "tests/rules/textures/texels.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<Wrap, 2> kRepeat{Wrap::repeat, Wrap::repeat};
constexpr std::array<Wrap, 2> kMirror{Wrap::mirrored_repeat, Wrap::mirrored_repeat};
constexpr std::array<Wrap, 2> kEdge{Wrap::clamp_to_edge, Wrap::clamp_to_edge};
constexpr std::array<Wrap, 2> kBorder{Wrap::clamp_to_border, Wrap::clamp_to_border};
constexpr std::array<float, 4> kHundred{100, 0, 0, 0};

Texels looked_up(const DecodedLevel& level, Filter filter, const TexturePoint& point,
                 const TexelLookup& lookup) {
  return filter_level(level, 2, TextureFormat::rgba32f, filter, point, lookup);
}

// The reds of the boxes, which must be points.
std::set<double> reds(const Texels& boxes) {
  std::set<double> result;
  for (const Texel& box : boxes) {
    EXPECT_EQ(box[0].low, box[0].high);
    result.insert(box[0].low);
  }
  EXPECT_EQ(result.size(), boxes.size());
  return result;
}

using Reds = std::set<double>;

// What the reds of the boxes lie between.
using RedEnds = std::multiset<Ends>;

RedEnds red_ends(const Texels& boxes) {
  RedEnds result;
  for (const Texel& box : boxes) result.insert(ends_of(box[0]));
  return result;
}

RedEnds linear_of_row(int texels, Interval s, const std::array<Wrap, 2>& wrap, double slack = 0) {
  TexelLookup lookup{wrap, kHundred};
  lookup.slack = slack;
  return red_ends(looked_up(numbered(texels, 1), Filter::linear, {s, 0.5}, lookup));
}

// Texels 0 to 3 in a row.
Reds nearest_of_four(Interval s, const std::array<Wrap, 2>& wrap, double slack = 0) {
  TexelLookup lookup{wrap, kHundred};
  lookup.slack = slack;
  return reds(looked_up(numbered(4, 1), Filter::nearest, {s, 0.5}, lookup));
}

TEST(Nearest, TakesTheTexelThatHoldsThePoint) {
  EXPECT_EQ(nearest_of_four(0.3, kRepeat), Reds{1});
  EXPECT_EQ(nearest_of_four(-0.01, kRepeat), Reds{3});
  EXPECT_EQ(nearest_of_four(-0.01, kMirror), Reds{0});
  EXPECT_EQ(nearest_of_four(-0.01, kEdge), Reds{0});
  EXPECT_EQ(nearest_of_four(-0.01, kBorder), Reds{100});
  EXPECT_EQ(nearest_of_four(1, kBorder), Reds{100});
}

TEST(Nearest, TakesTheUpperTexelOnABorder) {
  EXPECT_EQ(nearest_of_four(0.25, kEdge), Reds{1});
  EXPECT_EQ(nearest_of_four(std::nextafter(0.25, 0), kEdge), Reds{0});
  EXPECT_EQ(nearest_of_four(-5e-324, kBorder), Reds{100});
  EXPECT_EQ(nearest_of_four(0, kBorder), Reds{0});
}

TEST(Nearest, IsNotMovedOverABorderByRounding) {
  // The double below 1/3, times 3, rounds to 1; that below 2/3 to 2.
  const DecodedLevel level = numbered(3, 1);
  const TexelLookup lookup{kEdge, kHundred};
  const auto at = [&](Interval s) {
    return reds(looked_up(level, Filter::nearest, {s, 0}, lookup));
  };
  const double third = 1.0 / 3;
  const double next = std::nextafter(third, 1);
  EXPECT_EQ(at(third), Reds{0});
  EXPECT_EQ(at(next), Reds{1});
  EXPECT_EQ(at(Interval(third - 0.1, third)), Reds{0});
  EXPECT_EQ(at(Interval(third, next)), (Reds{0, 1}));
  EXPECT_EQ(at(2.0 / 3), Reds{1});
}

TEST(Nearest, TakesEveryTexelThatAnIntervalTouches) {
  EXPECT_EQ(nearest_of_four({0.2, 0.3}, kRepeat), (Reds{0, 1}));
  EXPECT_EQ(nearest_of_four({0.2, 0.25}, kRepeat), (Reds{0, 1}));
  EXPECT_EQ(nearest_of_four({-0.3, 0.1}, kBorder), (Reds{0, 100}));
  EXPECT_EQ(nearest_of_four({-0.3, 0.1}, kEdge), Reds{0});
  EXPECT_EQ(nearest_of_four({-0.3, 0.1}, kRepeat), (Reds{0, 2, 3}));
  EXPECT_EQ(nearest_of_four({0.9, 1.6}, kMirror), (Reds{1, 2, 3}));
}

TEST(Nearest, IsAsFarOffAsTheSlackSays) {
  EXPECT_EQ(nearest_of_four(0.25, kRepeat, 0.125), (Reds{0, 1}));
  EXPECT_EQ(nearest_of_four(0.3, kRepeat, 0.125), Reds{1});
  EXPECT_EQ(nearest_of_four(0.3, kRepeat, 0.25), (Reds{0, 1}));
  EXPECT_EQ(nearest_of_four(0.5, kRepeat, 1.5), (Reds{0, 1, 2, 3}));
  EXPECT_EQ(nearest_of_four(0.5, kEdge, 1e300), (Reds{0, 1, 2, 3}));
  EXPECT_EQ(nearest_of_four(1e300, kRepeat, 1e290), (Reds{0, 1, 2, 3}));
  EXPECT_EQ(nearest_of_four(1e300, kEdge, 1e290), Reds{3});
}

TEST(Coordinates, ThatAreNoNumbersAreZero) {
  for (const double s : {kInfinity, -kInfinity, kNaN})
    for (const auto& wrap : {kRepeat, kMirror, kEdge, kBorder}) {
      EXPECT_EQ(nearest_of_four(s, wrap), Reds{0});
      const TexelLookup lookup{wrap, kHundred};
      const auto linear = looked_up(numbered(4, 4), Filter::linear, {s, s}, lookup);
      const auto at_zero = looked_up(numbered(4, 4), Filter::linear, {0, 0}, lookup);
      ASSERT_EQ(linear.size(), 1U);
      EXPECT_EQ(ends_of(linear[0][0]), ends_of(at_zero[0][0]));
    }
}

TEST(Coordinates, ThatAreHugeRepeatExactly) {
  // From 2^53 on every double is an even number of images.
  EXPECT_EQ(nearest_of_four(1e300, kRepeat), Reds{0});
  EXPECT_EQ(nearest_of_four(-1e300, kMirror), Reds{0});
  EXPECT_EQ(nearest_of_four(std::numeric_limits<double>::max(), kMirror), Reds{0});
  EXPECT_EQ(nearest_of_four(0x1p50 + 1.75, kRepeat), Reds{3});
  EXPECT_EQ(nearest_of_four(0x1p50 + 1.75, kMirror), Reds{0});
  EXPECT_EQ(nearest_of_four(1e300, kEdge), Reds{3});
  EXPECT_EQ(nearest_of_four(-1e300, kEdge), Reds{0});
  EXPECT_EQ(nearest_of_four(-1e308, kBorder), Reds{100});
}

TEST(Coordinates, AtInfinityWithAnEndThatIsNoNumberAreZero) {
  for (const auto& wrap : {kRepeat, kMirror, kEdge, kBorder}) {
    EXPECT_EQ(nearest_of_four({kNaN, -kInfinity}, wrap), Reds{0});
    EXPECT_EQ(nearest_of_four({kInfinity, kNaN}, wrap), Reds{0});
  }
}

TEST(Coordinates, FromFourOnAreThoseOfTheImagesAtZero) {
  for (const auto& wrap : {kRepeat, kMirror})
    for (const Interval s : {Interval(4.3), Interval(4.9), Interval(-4.3), Interval(4.3, 4.9),
                             Interval(3.3, 4), Interval(-4.7, -3.1)}) {
      const double images = 2 * std::floor(s.low / 2);
      EXPECT_EQ(linear_of_row(3, s, wrap),
                linear_of_row(3, {s.low - images, s.high - images}, wrap));
    }
}

TEST(Coordinates, AreNotRoundedOnTheWayToTheImagesAtZero) {
  // Up to the centre of a texel, and up to where the next one begins to count.
  EXPECT_EQ(linear_of_row(4, {-3, -1.125}, kRepeat).size(), 5U);
  EXPECT_EQ(linear_of_row(4, {-3, -1.125 + 0x1p-52}, kRepeat).size(), 6U);
}

TEST(Coordinates, OfAnInfiniteIntervalReachAllThatTheModeReaches) {
  const Reds all{0, 1, 2, 3};
  for (const Interval s : {Interval::everything(), Interval(-1e300, 1e300), Interval(kNaN, 0.0),
                           Interval(-kInfinity, 1e308)}) {
    EXPECT_EQ(nearest_of_four(s, kRepeat), all);
    EXPECT_EQ(nearest_of_four(s, kMirror), all);
  }
  EXPECT_EQ(nearest_of_four(Interval::everything(), kEdge), all);
  EXPECT_EQ(nearest_of_four(Interval::everything(), kBorder), (Reds{0, 1, 2, 3, 100}));
  EXPECT_EQ(nearest_of_four({0.6, kInfinity}, kEdge), (Reds{2, 3}));
  EXPECT_EQ(nearest_of_four({-kInfinity, -1}, kBorder), Reds{100});
  EXPECT_EQ(nearest_of_four({-1, 1e300}, kRepeat), all);
}

TEST(Linear, IsExactAtCentresAndOverConstantTextures) {
  const TexelLookup lookup{kRepeat, kHundred};
  const auto centre = looked_up(numbered(4, 4), Filter::linear, {0.375, 0.625}, lookup);
  EXPECT_EQ(reds(centre), Reds{2 * 4 + 1});
  const DecodedLevel constant = decode({3, 2, std::vector<float>(24, 77)}, TextureFormat::srgb8);
  const auto boxes = looked_up(constant, Filter::linear, {{-0.1, 2.7}, 0.123}, lookup);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_EQ(ends_of(boxes[0][0]), ends_of(srgb_to_linear(77)));
}

TEST(Linear, WeighsTheFourAround) {
  const TexelLookup lookup{kRepeat, kHundred};
  // A quarter of the way from texel 0 to 1, and halfway from row 0 to 1.
  const auto boxes = looked_up(numbered(4, 4), Filter::linear, {0.1875, 0.25}, lookup);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_TRUE(boxes[0][0].contains(0.25 + 2));
  EXPECT_LT(boxes[0][0].high - boxes[0][0].low, 1e-14);
}

TEST(Linear, AtABorderMixesIt) {
  const TexelLookup lookup{kBorder, kHundred};
  const auto boxes = looked_up(numbered(4, 1), Filter::linear, {1, 0.5}, lookup);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_TRUE(boxes[0][0].contains(51.5));
  EXPECT_EQ(reds(looked_up(numbered(4, 1), Filter::linear, {1e9, 0.5}, lookup)), Reds{100});
}

TEST(Linear, HasABoxForEveryQuadOfAnInterval) {
  const TexelLookup lookup{kEdge, kHundred};
  // From a quarter beyond texel 0 to a quarter beyond texel 2.
  const auto boxes = looked_up(numbered(4, 1), Filter::linear, {{0.1875, 0.6875}, 0.5}, lookup);
  ASSERT_EQ(boxes.size(), 3U);
  EXPECT_EQ(ends_of(boxes[1][0]), Ends(1.0, 2.0));
  EXPECT_NEAR(boxes[0][0].low, 0.25, 1e-15);
  EXPECT_EQ(boxes[0][0].high, 1);
  EXPECT_EQ(boxes[2][0].low, 2);
  EXPECT_NEAR(boxes[2][0].high, 2.25, 1e-15);
}

TEST(Linear, HasABoxForEveryQuadThereIs) {
  const Interval s = Interval::everything();
  EXPECT_EQ(linear_of_row(4, s, kRepeat), (RedEnds{{0, 1}, {1, 2}, {2, 3}, {0, 3}}));
  EXPECT_EQ(linear_of_row(4, s, kMirror), (RedEnds{{0, 0}, {0, 1}, {1, 2}, {2, 3}, {3, 3}}));
}

TEST(Linear, HasABoxForWhatLiesBeyondAnEdge) {
  // To the left of texel 1's centre, and to the right of texel 2's.
  const Interval left{-kInfinity, 0.375};
  const Interval right{0.625, kInfinity};
  EXPECT_EQ(linear_of_row(4, left, kBorder), (RedEnds{{100, 100}, {0, 100}, {0, 1}}));
  EXPECT_EQ(linear_of_row(4, right, kBorder), (RedEnds{{2, 3}, {3, 100}, {100, 100}}));
  EXPECT_EQ(linear_of_row(4, left, kEdge), (RedEnds{{0, 0}, {0, 1}}));
  EXPECT_EQ(linear_of_row(4, right, kEdge), (RedEnds{{2, 3}, {3, 3}}));
}

TEST(Linear, HasNoPartialQuadsFromTwoImagesOn) {
  const RedEnds whole{{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  EXPECT_EQ(linear_of_row(4, {0.1875, 2.1875}, kRepeat), whole);
  EXPECT_EQ(linear_of_row(4, {0.1875, 2.5625}, kRepeat), whole);
  EXPECT_EQ(linear_of_row(4, {0.125, 1.875}, kRepeat, 0.6), whole);
  // Less than two images with the slack, 1.95: two parts of the quad of texels 3 and 0 as well.
  EXPECT_EQ(linear_of_row(4, {0.125, 1.875}, kRepeat, 0.4).size(), whole.size() + 2);
}

// About the middle of an image of odd sides, where texels have their centres: two cells.
constexpr double kBelowHalf = 0.5 - 0x1p-54;
constexpr double kAboveHalf = 0.5 + 0x1p-53;

TEST(Linear, IsOnePointWhereOnlyTheEdgeIs) {
  // From a texel and a half beyond.
  for (const Interval s : {Interval(-9), Interval(9), Interval(-0.7, -0.6), Interval(1.6, 1.7),
                           Interval(-kInfinity, -0.5), Interval(1.5, kInfinity)}) {
    const TexturePoint point{s, {kBelowHalf, kAboveHalf}};
    EXPECT_EQ(looked_up(numbered(3, 3), Filter::linear, point, {kEdge, kHundred}).size(), 1U);
    EXPECT_EQ(looked_up(numbered(3, 3), Filter::linear, point, {kBorder, kHundred}).size(), 1U);
  }
}

TEST(Linear, IsOneColourWhereLessThan2ToTheMinus20TexelsWide) {
  const auto about_a_centre = [](double width) {
    return Interval((1.5 - width / 2) / 4, (1.5 + width / 2) / 4);
  };
  EXPECT_EQ(linear_of_row(4, about_a_centre(0x1p-21), kRepeat).size(), 1U);
  EXPECT_EQ(linear_of_row(4, about_a_centre(0x1p-20), kRepeat).size(), 2U);
  EXPECT_EQ(linear_of_row(4, about_a_centre(0x1p-19), kRepeat).size(), 2U);
  const TexelLookup lookup{kRepeat, kHundred};
  EXPECT_EQ(filter_level(numbered(4, 1), 1, TextureFormat::rgba32f, Filter::linear,
                         {about_a_centre(0x1p-21), kNaN}, lookup)
                .size(),
            1U);
}

TEST(Linear, EndsWithTheTexelItselfAtItsCentre) {
  // Where weights are rounded, a weight of 1 still is no rounding.
  const DecodedLevel level{2, 1, {{1 + 0x1p-28, 0, 0, 0}, {1 + 0x1p-27, 0, 0, 0}}};
  const auto red = [&](Interval s) {
    return looked_up(level, Filter::linear, {s, 0.5}, {kRepeat, kHundred}).at(0)[0];
  };
  const double before = 0.75 - 0x1p-28;
  EXPECT_EQ(ends_of(red(0.75)), Ends(1 + 0x1p-27, 1 + 0x1p-27));
  EXPECT_EQ(ends_of(red({before, 0.75})), Ends(red(before).low, 1 + 0x1p-27));
}

TEST(Linear, IsOneColourWhereACoordinateIsExactButForRounding) {
  const TexelLookup lookup{kRepeat, kHundred};
  // About the centre of texel (1, 1) of 3x3: four quads meet.
  const Interval half{std::nextafter(0.5, 0), std::nextafter(0.5, 1)};
  const auto boxes = looked_up(numbered(3, 3), Filter::linear, {half, half}, lookup);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_TRUE(boxes[0][0].contains(4));
  EXPECT_LT(boxes[0][0].high - boxes[0][0].low, 1e-14);
}

TEST(OneDimension, IgnoresT) {
  const TexelLookup lookup{kBorder, kHundred};
  for (const Filter filter : {Filter::nearest, Filter::linear})
    for (const Interval t : {Interval(0.5), Interval(-7), Interval(kNaN), Interval::everything()}) {
      const auto boxes =
          filter_level(numbered(4, 1), 1, TextureFormat::rgba32f, filter, {0.625, t}, lookup);
      EXPECT_EQ(reds(boxes), Reds{2});
    }
}

TEST(Boxes, AreFewAndHoldAllTexels) {
  const DecodedLevel level = numbered(300, 200);
  for (const auto& wrap : {kRepeat, kMirror, kEdge, kBorder})
    for (const Filter filter : {Filter::nearest, Filter::linear}) {
      const TexturePoint anywhere{Interval::everything(), {-1e308, 1e308}};
      const auto boxes = looked_up(level, filter, anywhere, {wrap, kHundred});
      EXPECT_LE(boxes.size(), kMostBoxes);
      for (const double red : {0.0, 299.0, 59999.0, 12345.0})
        EXPECT_TRUE(std::any_of(boxes.begin(), boxes.end(),
                                [&](const Texel& box) { return box[0].contains(red); }));
    }
}

TEST(Boxes, OfASmallTextureAreItsTexels) {
  const TexturePoint anywhere{Interval::everything(), Interval::everything()};
  const auto boxes = looked_up(numbered(64, 64), Filter::nearest, anywhere, {kMirror, kHundred});
  EXPECT_EQ(boxes.size(), 4096U);
  EXPECT_EQ(reds(boxes).size(), 4096U);
}

TEST(Boxes, OfALongTextureAreSharedByFewCells) {
  // A period of 10,000 cells, three to a box.
  const TexturePoint anywhere{Interval::everything(), Interval::everything()};
  for (const DecodedLevel& level : {numbered(5000, 1), numbered(1, 5000)})
    EXPECT_EQ(looked_up(level, Filter::linear, anywhere, {kMirror, kHundred}).size(), 3334U);
}

TEST(Boxes, OfMoreThan4096TexelsAreShared) {
  // 4097 texels, by 2 times 2.
  const TexturePoint anywhere{Interval::everything(), Interval::everything()};
  const auto boxes = looked_up(numbered(17, 241), Filter::nearest, anywhere, {kEdge, kHundred});
  EXPECT_EQ(boxes.size(), 9U * 121U);
}

TEST(Boxes, ThatDifferInOneEndAreTwo) {
  const TexturePoint anywhere{Interval::everything(), 0.5};
  const Texel zeros{0, 0, 0, 0};
  for (std::size_t k = 0; k < 4; ++k)
    for (const Interval other : {Interval(0, 1), Interval(-1, 0)}) {
      Texel texel = zeros;
      texel[k] = other;
      const DecodedLevel level{4, 1, {zeros, texel, zeros, texel}};
      const auto boxes = looked_up(level, Filter::nearest, anywhere, {kEdge, kHundred});
      EXPECT_EQ(boxes.size(), 2U) << k;
    }
}

TEST(Grid, RoundsDownOrToTheNearestStep) {
  const auto on = [](double value, TexelGrid grid) { return on_grid(Interval(value), grid).low; };
  for (const double below : {0.0, -3.0, 1000.25, 77 / 256.0}) {
    const double step = 1 / 256.0;
    EXPECT_EQ(on(below, TexelGrid::floor_8), below);
    EXPECT_EQ(on(below + 0.99 * step, TexelGrid::floor_8), below);
    EXPECT_EQ(on(below + 0.49 * step, TexelGrid::nearest_8), below);
    EXPECT_EQ(on(below + 0.5 * step, TexelGrid::nearest_8), below + step);
    EXPECT_EQ(on(below + 0.99 * step, TexelGrid::nearest_8), below + step);
    EXPECT_EQ(on(below + 0.123, TexelGrid::none), below + 0.123);
  }
  EXPECT_EQ(on(-1e-300, TexelGrid::floor_8), -1 / 256.0);
  EXPECT_EQ(on(-1e-300, TexelGrid::nearest_8), 0);
  EXPECT_EQ(on(1e300, TexelGrid::floor_8), 1e300);
  EXPECT_EQ(on(0x1p44 - 0x1p-9, TexelGrid::floor_8), 0x1p44 - 0x1p-8);
  EXPECT_EQ(on(-kInfinity, TexelGrid::nearest_8), -kInfinity);
}

TEST(Grid, MovesWeightsAndBorders) {
  TexelLookup lookup{kEdge, kHundred};
  lookup.grid = TexelGrid::floor_8;
  // 0.7 steps beyond the centre of texel 1: none; 1.7 steps: one.
  const auto red_at = [&](double u, Filter filter) {
    return reds(looked_up(numbered(4, 1), filter, {u / 4, 0.5}, lookup));
  };
  EXPECT_EQ(red_at(1.5 + 0.7 / 256, Filter::linear), Reds{1});
  const auto boxes =
      looked_up(numbered(4, 1), Filter::linear, {(1.5 + 1.7 / 256) / 4, 0.5}, lookup);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_TRUE(boxes[0][0].contains(1 + 1 / 256.0));
  EXPECT_EQ(red_at(2 - 0.3 / 256, Filter::nearest), Reds{1});
  lookup.grid = TexelGrid::nearest_8;
  EXPECT_EQ(red_at(1.5 + 0.7 / 256, Filter::nearest), Reds{1});
  EXPECT_EQ(red_at(2 - 0.3 / 256, Filter::nearest), Reds{2});
  EXPECT_EQ(red_at(2 - 0.5 / 256, Filter::nearest), Reds{2});
  EXPECT_EQ(red_at(2 - 0.6 / 256, Filter::nearest), Reds{1});
}

TEST(GridNames, AreThoseOfTheCatalogue) {
  for (const Alternative& alternative : texel_grid_rule().alternatives) {
    TexelGrid grid{};
    ASSERT_TRUE(parse_name(alternative.name, grid));
    EXPECT_EQ(name_of(grid), alternative.name);
  }
  TexelGrid grid = TexelGrid::floor_8;
  EXPECT_FALSE(parse_name("floor", grid));
  EXPECT_EQ(grid, TexelGrid::floor_8);
}

}  // namespace
}  // namespace edgecase
