// SPDX-License-Identifier: MIT
//
// The sets of alternatives that a search tries, their order, and where it ends.
#include "rules/change_search.h"

#include <gmock/gmock.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "rules/all_rules.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr AlternativeId kA0{RuleId::triangle_snap, 0}, kA1{RuleId::triangle_snap, 1};
constexpr AlternativeId kB0{RuleId::polygon_facing, 0}, kB1{RuleId::polygon_facing, 1};
constexpr AlternativeId kC0{RuleId::triangle_row_order, 0};

const std::vector<Changes> kRules{{{kA0}, {kA1}}, {{kB0}, {kB1}}, {}, {{kC0}}};

using Ids = std::vector<AlternativeId>;

std::vector<Ids> ids_of(const std::vector<Changes>& sets) {
  std::vector<Ids> ids;
  for (const Changes& set : sets) ids.push_back(cause_of(set).parts);
  return ids;
}

std::vector<Ids> visited_pairs(const Changes& changes) {
  std::vector<Ids> pairs;
  for_each_pair(changes, [&](std::size_t i, std::size_t j) {
    pairs.push_back({changes[i].id, changes[j].id});
  });
  return pairs;
}

TEST(ChangeSearch, SinglesComeRuleByRule) {
  EXPECT_THAT(ids_of(singles_of(kRules)),
              ElementsAre(Ids{kA0}, Ids{kA1}, Ids{kB0}, Ids{kB1}, Ids{kC0}));
  EXPECT_THAT(cause_of(joined(kRules)).parts, ElementsAre(kA0, kA1, kB0, kB1, kC0));
}

TEST(ChangeSearch, PairsOfSetsComeByPairsOfRules) {
  EXPECT_THAT(ids_of(pairs_of(kRules)),
              ElementsAre(Ids{kA0, kB0}, Ids{kA0, kB1}, Ids{kA1, kB0}, Ids{kA1, kB1}, Ids{kA0, kC0},
                          Ids{kA1, kC0}, Ids{kB0, kC0}, Ids{kB1, kC0}));
}

TEST(ChangeSearch, VisitedPairsComeByTheirFirstAlternative) {
  EXPECT_THAT(visited_pairs(joined(kRules)),
              ElementsAre(Ids{kA0, kB0}, Ids{kA0, kB1}, Ids{kA0, kC0}, Ids{kA1, kB0}, Ids{kA1, kB1},
                          Ids{kA1, kC0}, Ids{kB0, kC0}, Ids{kB1, kC0}));
}

TEST(ChangeSearch, OneRuleOrNoneHasNoPairs) {
  for (const std::vector<Changes>& rules :
       {std::vector<Changes>{}, {{}, {}}, {{{kA0}, {kA1}}}, {{{kA0}, {kA1}}, {}}}) {
    EXPECT_THAT(pairs_of(rules), IsEmpty());
    EXPECT_THAT(visited_pairs(joined(rules)), IsEmpty());
  }
}

// Every pair of a catalogue's worth of alternatives, against a search of all ordered pairs.
TEST(ChangeSearch, BothOrdersHaveEachPairOfDifferentRulesOnce) {
  std::vector<Changes> rules;
  for (const RuleId rule : coverage_rules())
    rules.push_back(changes_beside(rule, standard_choices()));
  const Changes all = joined(rules);
  std::set<Ids> expected;
  for (const Change& one : all)
    for (const Change& other : all)
      if (one.id.rule < other.id.rule) expected.insert({one.id, other.id});
  for (const std::vector<Ids>& pairs : {ids_of(pairs_of(rules)), visited_pairs(all)}) {
    EXPECT_EQ(pairs.size(), expected.size());
    EXPECT_EQ(std::set<Ids>(pairs.begin(), pairs.end()), expected);
  }
}

TEST(ChangeSearch, TheFirstThatFitsIsTheLastThatIsTested) {
  int tested = 0;
  const auto is_of_b = [&](const Change& change) {
    ++tested;
    return change.id.rule == kB0.rule;
  };
  EXPECT_EQ(first_cause(joined(kRules), is_of_b), Cause(kB0));
  EXPECT_EQ(tested, 3);
}

TEST(ChangeSearch, ASetThatFitsIsTheCauseAsAWhole) {
  const auto has_c = [](const Changes& set) { return set.back().id == kC0; };
  EXPECT_EQ(first_cause(pairs_of(kRules), has_c), Cause(kA0) + kC0);
}

TEST(ChangeSearch, WithoutAFitThereIsNoCause) {
  int tested = 0;
  const auto never = [&](const Changes&) { return ++tested < 0; };
  EXPECT_EQ(first_cause(singles_of(kRules), never), Cause());
  EXPECT_EQ(tested, 5);
}

}  // namespace
}  // namespace edgecase
