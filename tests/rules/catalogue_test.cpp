// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "rules/all_rules.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

TEST(Catalogue, IdsAndRulingNumbersAreUnique) {
  std::set<std::string> ids;
  std::set<int> rulings;
  for (const Rule& rule : all_rules()) {
    EXPECT_TRUE(ids.insert(rule.id).second) << rule.id;
    for (const Ruling& ruling : rule.rulings)
      EXPECT_TRUE(rulings.insert(ruling.number).second) << ruling.number;
  }
  EXPECT_EQ(*rulings.begin(), 1);
}

TEST(Catalogue, EveryRuleSaysWhatItIs) {
  for (const Rule& rule : all_rules()) {
    EXPECT_FALSE(rule.title.empty()) << rule.id;
    EXPECT_FALSE(rule.spec.empty()) << rule.id;
    EXPECT_FALSE(rule.latitude.empty()) << rule.id;
    std::set<std::string> names;
    for (const Alternative& alternative : rule.alternatives) {
      EXPECT_TRUE(names.insert(alternative.name).second) << rule.id << " " << alternative.name;
      EXPECT_FALSE(alternative.meaning.empty()) << rule.id << " " << alternative.name;
    }
    EXPECT_EQ(rule.standard.empty(), rule.alternatives.empty()) << rule.id;
    EXPECT_EQ(find_alternative(rule, rule.standard) == nullptr, rule.standard.empty()) << rule.id;
  }
}

TEST(Choices, DefaultsAreThoseOfTheCatalogue) {
  const RuleChoices choices = resolve(Policy{}, Surface::fbo);
  EXPECT_EQ(choices.lines.line.boundary->name, "left-bottom");
  EXPECT_EQ(choices.lines.line.algorithm, LineAlgorithm::diamond_exit);
  EXPECT_EQ(choices.triangles.ties.name, "left-top");
  EXPECT_EQ(choices.points.ties.name, "right-top");
  EXPECT_TRUE(choices.lines.snap.is_none());
}

TEST(Choices, ASnapOfOnePrimitiveTypeOverridesTheCommonOne) {
  Policy policy;
  policy.rules = {{"subpixel.snap", "8-half-even"}, {"line.snap", "none"}};
  const RuleChoices choices = resolve(policy, Surface::fbo);
  EXPECT_EQ(name_of(choices.triangles.snap), "8-half-even");
  EXPECT_EQ(name_of(choices.points.snap), "8-half-even");
  EXPECT_EQ(name_of(choices.lines.snap), "none");
}

TEST(Choices, HoldEveryAlternativeThatAPolicyNames) {
  Policy policy;
  policy.rules = {{"triangle.algorithm", "scan"},     {"point.offset", "right-down"},
                  {"point.row-order", "top-down"},    {"line.width", "shifted-triangles"},
                  {"line.algorithm", "midpoint"},     {"line.diamond-exit", "scotty3d"},
                  {"attribute.smooth", "major-axis"}, {"attribute.provoking-vertex", "first"}};
  const RuleChoices choices = resolve(policy, Surface::fbo);
  EXPECT_EQ(choices.triangles.triangle_algorithm, TriangleAlgorithm::scan);
  EXPECT_EQ(choices.points.point_offset, PointOffset::right_down);
  EXPECT_EQ(choices.points.rows, RowOrder::top_down);
  EXPECT_EQ(choices.lines.rows, RowOrder::bottom_up);
  EXPECT_EQ(choices.lines.line.wide, WideLine::shifted_triangles);
  EXPECT_EQ(choices.lines.line.algorithm, LineAlgorithm::midpoint);
  EXPECT_EQ(choices.lines.line.boundary->name, "scotty3d");
  EXPECT_EQ(choices.values.line_parameter, LineParameter::major_axis);
  EXPECT_EQ(choices.values.provoking, ProvokingChoice::first);
}

TEST(Choices, HoldEveryAlternativeOfValuesThatAPolicyNames) {
  Policy policy;
  policy.rules = {{"attribute.perspective", "never"}, {"attribute.positions", "snapped"},
                  {"derivative.plain", "forward"},    {"derivative.fine", "quad-other-row"},
                  {"derivative.coarse", "analytic"},  {"derivative.quad-rows", "top-down"}};
  for (const auto& [rule, alternative] : policy.rules)
    EXPECT_NE(find_alternative(*find_rule(rule), alternative), nullptr) << rule;
  const ValueChoice values = resolve(policy, Surface::fbo).values;
  EXPECT_EQ(values.perspective, PerspectiveChoice::never);
  EXPECT_EQ(values.positions, AttributePositions::snapped);
  EXPECT_EQ(values.derivatives, (std::array{DerivativeMethod::forward, DerivativeMethod::other_row,
                                            DerivativeMethod::analytic}));
  EXPECT_EQ(values.quad_rows, RowOrder::top_down);
}

TEST(Choices, ASurfaceOverridesThePolicy) {
  Policy policy;
  policy.rules = {{"triangle.fill-rule", "right-top"}};
  policy.surfaces[Surface::fbo] = {{"triangle.fill-rule", "bottom-left"}};
  EXPECT_EQ(resolve(policy, Surface::fbo).triangles.ties.name, "bottom-left");
}

}  // namespace
}  // namespace edgecase
