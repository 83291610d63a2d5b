// SPDX-License-Identifier: MIT
//
// Tables and defaults that other code relies on, held against what their headers say.
#include <gmock/gmock.h>

#include <array>
#include <cstdlib>

#include "exact/fixed.h"
#include "exact/interval.h"
#include "rules/all_rules.h"
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/tie_rule.h"
#include "rules/rule.h"
#include "rules/values/framebuffer.h"
#include "tests/support/points.h"

namespace edgecase {

enum class ExampleSide { left, right, bottom };
template <>
inline constexpr auto kNames<ExampleSide> = std::to_array<TabledAlternative<ExampleSide>>(
    {{ExampleSide::right, "right", Openness::mandated, "the right"},
     {ExampleSide::left, "left", Openness::open, "the left"}});

namespace {

using ::testing::ElementsAre;

// The sample's move that a word asks for: left edges own it when it moves right, and so on.
std::pair<int, int> move_of(std::string_view word) {
  if (word == "left") return {1, 0};
  if (word == "right") return {-1, 0};
  if (word == "bottom") return {0, 1};
  return {0, -1};
}

TEST(AlternativeTables, SayNamesAndValuesInTheirOrder) {
  EXPECT_THAT(values_of<ExampleSide>(), ElementsAre(ExampleSide::right, ExampleSide::left));
  EXPECT_THAT(names_of<ExampleSide>(), ElementsAre("right", "left"));
  EXPECT_STREQ(name_of(ExampleSide::left), "left");
  EXPECT_STREQ(name_of(ExampleSide::bottom), "?");
  ExampleSide side = ExampleSide::bottom;
  EXPECT_FALSE(parse_name("bottom", side));
  EXPECT_EQ(side, ExampleSide::bottom);
  EXPECT_TRUE(parse_name("right", side));
  EXPECT_EQ(side, ExampleSide::right);
  const std::vector<Alternative> alternatives = alternatives_of<ExampleSide>();
  ASSERT_EQ(alternatives.size(), 2U);
  EXPECT_EQ(alternatives[1].name, "left");
  EXPECT_EQ(alternatives[1].openness, Openness::open);
  EXPECT_EQ(alternatives[1].meaning, "the left");
}

TEST(TieRules, MoveTheSampleAsTheirNamesSay) {
  int perturbed = 0;
  for (const TieRule& rule : all_tie_rules()) {
    const std::string_view name = rule.name;
    if (rule.kind != TieRule::Kind::perturbed) {
      EXPECT_EQ(rule.kind == TieRule::Kind::open ? "open" : "closed", name);
      for (int component : {rule.first_x, rule.first_y, rule.second_x, rule.second_y})
        EXPECT_EQ(component, 0) << name;
      continue;
    }
    ++perturbed;
    const std::size_t dash = name.find('-');
    EXPECT_EQ(std::pair(rule.first_x, rule.first_y), move_of(name.substr(0, dash))) << name;
    EXPECT_EQ(std::pair(rule.second_x, rule.second_y), move_of(name.substr(dash + 1))) << name;
  }
  EXPECT_EQ(perturbed, 8);
}

TEST(TieRules, ATieThatNoMoveDecidesIsOutside) {
  // A function that does not grow has no inside to move into.
  for (const TieRule& rule : all_tie_rules())
    EXPECT_EQ(rule.positive(0, 0, 0), rule.kind == TieRule::Kind::closed) << rule.name;
}

TEST(TieRules, TheSmallestValueIsNoTie) {
  for (const TieRule& rule : all_tie_rules()) {
    EXPECT_TRUE(rule.positive(1, -1, -1)) << rule.name;
    EXPECT_TRUE(rule.positive(1, 1, 1)) << rule.name;
    EXPECT_FALSE(rule.positive(-1, 1, 1)) << rule.name;
    EXPECT_FALSE(rule.positive(-1, -1, -1)) << rule.name;
  }
}

TEST(TieRules, ADefaultOneMovesNothing) {
  const TieRule rule;
  EXPECT_FALSE(rule.positive(0, 1, 1));
  EXPECT_FALSE(rule.positive(0, -1, -1));
  EXPECT_FALSE(rule.positive(0, 1, -1));
}

TEST(TieRules, MeaningsNameTheMove) {
  const auto alternatives = tie_alternatives(all_tie_rules(), Openness::open, Openness::illegal);
  const char* meanings[] = {"a sample on a boundary moves by (+e, +e^2), y up",
                            "a sample on a boundary moves by (+e, -e^2), y up",
                            "a sample on a boundary moves by (-e, +e^2), y up",
                            "a sample on a boundary moves by (-e, -e^2), y up",
                            "a sample on a boundary moves by (+e^2, +e), y up",
                            "a sample on a boundary moves by (-e^2, +e), y up",
                            "a sample on a boundary moves by (+e^2, -e), y up",
                            "a sample on a boundary moves by (-e^2, -e), y up",
                            "boundaries never count as inside",
                            "boundaries always count as inside"};
  ASSERT_EQ(alternatives.size(), std::size(meanings));
  for (std::size_t i = 0; i < alternatives.size(); ++i) {
    EXPECT_EQ(alternatives[i].meaning, meanings[i]) << alternatives[i].name;
    EXPECT_EQ(alternatives[i].openness, i < 8 ? Openness::open : Openness::illegal);
  }
}

TEST(DiamondBoundaries, OwnTheParts) {
  for (const TieRule& rule : all_tie_rules()) {
    const DiamondBoundary* boundary = find_diamond_boundary(rule.name);
    ASSERT_NE(boundary, nullptr);
    EXPECT_EQ(boundary->ties, &rule);
    EXPECT_EQ(boundary->x_major_parts, 0u);
    EXPECT_EQ(boundary->y_major_parts, 0u);
  }
  const DiamondBoundary& direct3d = *find_diamond_boundary("direct3d");
  EXPECT_EQ(direct3d.ties, nullptr);
  EXPECT_EQ(direct3d.x_major_parts, kLowerLeftEdge + kLowerRightEdge + kBottomCorner);
  EXPECT_EQ(direct3d.y_major_parts,
            kLowerLeftEdge + kLowerRightEdge + kBottomCorner + kRightCorner);
  const DiamondBoundary& scotty = *find_diamond_boundary("scotty3d");
  EXPECT_EQ(scotty.ties, nullptr);
  EXPECT_EQ(scotty.x_major_parts, kLowerLeftEdge + kLowerRightEdge + kUpperLeftEdge +
                                      kUpperRightEdge + kLeftCorner + kBottomCorner);
  EXPECT_EQ(scotty.y_major_parts, scotty.x_major_parts);
  EXPECT_EQ(find_diamond_boundary("no such"), nullptr);
}

TEST(DiamondBoundaries, ADefaultOneOwnsNothing) {
  const DiamondBoundary boundary;
  EXPECT_EQ(boundary.ties, nullptr);
  EXPECT_EQ(boundary.x_major_parts, 0u);
  EXPECT_EQ(boundary.y_major_parts, 0u);
}

TEST(Defaults, AreEmptyOrZero) {
  EXPECT_EQ(PixelPosition(), (PixelPosition{0, 0}));
  const PixelBounds none;
  EXPECT_EQ(none.x_min, 0);
  EXPECT_EQ(none.y_min, 0);
  EXPECT_EQ(none.x_max, -1);
  EXPECT_EQ(none.y_max, -1);
  EXPECT_FALSE(none.contains({0, 0}));
  EXPECT_EQ(Interval().low, 0);
  EXPECT_EQ(Interval().high, 0);
  EXPECT_EQ(Unorm8Range().low, 0);
  EXPECT_EQ(Unorm8Range().high, 0);
  EXPECT_EQ(Ruling().number, 0);
  EXPECT_EQ(SeenLine().width, 1);
  EXPECT_EQ(SizedPoint().size, Fixed::from_integer(1));
}

TEST(PixelBounds, HoldTheirBorders) {
  const PixelBounds bounds{2, 3, 5, 4};
  int held = 0;
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) held += bounds.contains({x, y}) ? 1 : 0;
  EXPECT_EQ(held, 8);
  for (PixelPosition corner : {PixelPosition{2, 3}, {5, 3}, {2, 4}, {5, 4}})
    EXPECT_TRUE(bounds.contains(corner));
  const PixelBounds grown = bounds.grown(1);
  EXPECT_EQ(grown.x_min, 1);
  EXPECT_EQ(grown.y_min, 2);
  EXPECT_EQ(grown.x_max, 6);
  EXPECT_EQ(grown.y_max, 5);
}

TEST(Catalogue, FindsByNumberAndName) {
  ASSERT_NE(find_ruling(9), nullptr);
  EXPECT_EQ(find_ruling(9)->number, 9);
  EXPECT_EQ(find_ruling(1)->number, 1);
  EXPECT_EQ(find_ruling(0), nullptr);
  EXPECT_EQ(find_ruling(1000), nullptr);
  EXPECT_EQ(find_rule("no.such"), nullptr);
  EXPECT_EQ(find_alternative(*find_rule("line.algorithm"), "no-such"), nullptr);
  EXPECT_EQ(find_alternative(*find_rule("line.algorithm"), "midpoint")->name, "midpoint");
}

}  // namespace
}  // namespace edgecase
