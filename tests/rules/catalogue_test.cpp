// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "rules/all_rules.h"
#include "rules/catalogue.h"
#include "rules/choices.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

TEST(Catalogue, IdsAndRulingNumbersAreUnique) {
  std::set<std::string> ids;
  std::set<int> rulings;
  for (const Rule& rule : all_rules()) {
    EXPECT_TRUE(ids.insert(name_of(rule.id)).second) << name_of(rule.id);
    for (const Ruling& ruling : rule.rulings)
      EXPECT_TRUE(rulings.insert(ruling.number).second) << ruling.number;
  }
  // From 1 to 43 without gaps: what is withdrawn stays listed. Later ones are split from them.
  for (int number = 1; number <= 43; ++number) EXPECT_TRUE(rulings.contains(number)) << number;
  EXPECT_EQ(*rulings.begin(), 1);
}

TEST(Catalogue, WhatARulingForbidsIsIllegalOrContestedByItsBasisAlone) {
  for (const Rule& rule : all_rules())
    for (const Ruling& ruling : rule.rulings)
      EXPECT_EQ(legality_against(ruling.number),
                ruling.source.basis == Basis::contested ? Legality::contested : Legality::illegal)
          << ruling.number;
  EXPECT_EQ(legality_against(0), Legality::illegal);
  EXPECT_EQ(legality_against(9999), Legality::illegal);
}

TEST(Catalogue, FactsOfARulingAreThoseThatAreKnown) {
  Ruling ruling{7, "Text."};
  const auto names = [&ruling] {
    std::string text;
    for (const RulingFact& fact : facts_of(ruling)) text += fact.name + "=" + fact.text + ";";
    return text;
  };
  EXPECT_EQ(names(), "Basis=normative;");
  ruling.source.clause = "14.5";
  ruling.source.quotation = "so it is";
  ruling.source.khronos = "group.*";
  ruling.source.es = "same";
  EXPECT_EQ(names(), std::string("Basis=normative;Text=") + kRevision +
                         ", 14.5: \"so it is\";Conformance tests=group.*;OpenGL ES=same;");
  ruling.source.basis = Basis::contested;
  ruling.source.contest = "issue 57 is open";
  ruling.source.withdrawn = "it fell";
  EXPECT_THAT(names(),
              testing::StartsWith("Withdrawn=it fell;Basis=contested: issue 57 is open;Text="));
}

std::size_t words_in(const std::string& text) {
  std::istringstream words(text);
  return static_cast<std::size_t>(std::distance(std::istream_iterator<std::string>(words),
                                                std::istream_iterator<std::string>()));
}

TEST(Catalogue, EveryRulingSaysWhatItRestsOn) {
  for (const Rule& rule : all_rules())
    for (const auto& [number, text, source] : rule.rulings) {
      EXPECT_FALSE(source.clause.empty()) << number;
      EXPECT_FALSE(source.revision.empty()) << number;
      EXPECT_FALSE(source.quotation.empty()) << number;
      EXPECT_LE(words_in(source.quotation), 25U) << number;
      EXPECT_FALSE(source.khronos.empty()) << number;
      EXPECT_FALSE(source.es.empty()) << number;
      EXPECT_EQ(source.contest.empty(), source.basis == Basis::normative) << number;
      EXPECT_THAT(source.clause, testing::MatchesRegex("[A-Z0-9].*[0-9].*|[0-9].*")) << number;
    }
}

// A verdict cites a ruling alone: its text tells by itself whether it is contested.
TEST(Catalogue, ContestedRulingsSayFirstThatTheyAre) {
  for (const Rule& rule : all_rules())
    for (const Ruling& ruling : rule.rulings)
      EXPECT_EQ(ruling.text.starts_with("Contested: "), ruling.source.basis == Basis::contested)
          << ruling.number << ": " << ruling.text;
}

TEST(Catalogue, EverySourceIsThatOfARuling) {
  const std::map<int, RulingSource> sources = ruling_sources();
  for (int number = 1; number < 1000; ++number)
    EXPECT_EQ(!sources.contains(number), find_ruling(number) == nullptr) << number;
}

TEST(Catalogue, EveryRuleSaysWhatItIs) {
  for (const Rule& rule : all_rules()) {
    EXPECT_FALSE(rule.title.empty()) << name_of(rule.id);
    EXPECT_FALSE(rule.spec.empty()) << name_of(rule.id);
    EXPECT_FALSE(rule.latitude.empty()) << name_of(rule.id);
    std::set<std::string> names;
    for (const Alternative& alternative : rule.alternatives) {
      EXPECT_TRUE(names.insert(alternative.name).second)
          << name_of(rule.id) << " " << alternative.name;
      EXPECT_FALSE(alternative.meaning.empty()) << name_of(rule.id) << " " << alternative.name;
    }
    EXPECT_EQ(rule.standard.empty(), rule.alternatives.empty()) << name_of(rule.id);
    EXPECT_EQ(find_alternative(rule, rule.standard) == nullptr, rule.standard.empty())
        << name_of(rule.id);
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

// What a policy names is what choices hold, and a set of alternatives has room for each.
TEST(Catalogue, ChoicesKeepEveryAlternative) {
  for (const RuleId id : values_of<RuleId>()) {
    if (id == RuleId::none) continue;
    const Rule& rule = rule_of(id);
    EXPECT_EQ(rule.id, id);
    EXPECT_LE(rule.alternatives.size(), AlternativeSet::kMostOfARule) << name_of(id);
    EXPECT_EQ(rule.slot.put != nullptr, !rule.alternatives.empty()) << name_of(id);
    for (const Alternative& alternative : rule.alternatives) {
      RuleChoices choices = standard_choices();
      rule.slot.put(choices, alternative.name);
      EXPECT_EQ(rule.slot.kept(choices), alternative.name) << name_of(id);
      EXPECT_EQ(parse_cause(text_of(alternative_id(id, alternative.name))),
                Cause(alternative_id(id, alternative.name)));
    }
  }
}

}  // namespace
}  // namespace edgecase
