// SPDX-License-Identifier: MIT
//
// No disagreement is lost and none is invented: what a comparison that knows no rule finds, a plain
// difference of two multisets of (pixel, primitive), is exactly what compare() reports.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "diff/compare.h"
#include "diff/coverage/cause.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using Place = std::tuple<int, int, int>;                         // x, y, primitive
using Found = std::tuple<int, int, int, std::string, int, int>;  // and kind, exact, rendered

std::map<Place, int> counted(const Rendering& rendering) {
  std::map<Place, int> result;
  for (const Fragment& f : rendering.fragments) ++result[{f.x, f.y, f.primitive}];
  return result;
}

std::multiset<Found> plain_difference(const Rendering& exact, const Rendering& rendered) {
  const auto left = counted(exact), right = counted(rendered);
  const auto count = [](const auto& counts, const Place& place) {
    const auto found = counts.find(place);
    return found == counts.end() ? 0 : found->second;
  };
  std::set<Place> places;
  for (const auto* side : {&left, &right})
    for (const auto& [place, hits] : *side) places.insert(place);
  std::multiset<Found> result;
  for (const Place& place : places) {
    const int a = count(left, place), b = count(right, place);
    const auto add = [&](const char* kind) {
      result.insert(std::tuple_cat(place, std::tuple(std::string(kind), a, b)));
    };
    if (b < a) add("missing");
    if (a == 0) add("extra");
    if (b > 1) add("duplicate");
  }
  return result;
}

std::multiset<Found> reported(const Result& result) {
  std::multiset<Found> found;
  for (const Disagreement& d : result.disagreements)
    if (d.kind != DisagreementKind::value)
      found.insert({d.x, d.y, d.primitive, name_of(d.kind), static_cast<int>(d.exact.at(0)),
                    static_cast<int>(d.rendered.at(0))});
  return found;
}

// Alternatives for everything at random: ties of all kinds, snaps of all kinds.
Policy random_policy(RandomScenes& random) {
  Policy policy;
  for (const char* rule : {"triangle.fill-rule", "line.diamond-exit", "point.ownership",
                           "triangle.snap", "line.snap", "point.snap"}) {
    const auto& alternatives = find_rule(rule)->alternatives;
    const int choice = random.below(static_cast<int>(alternatives.size()));
    policy.rules[rule] = alternatives[static_cast<std::size_t>(choice)].name;
  }
  return policy;
}

// Now and then a fragment comes twice, goes missing or comes from nowhere.
void damage(Rendering& rendering, RandomScenes& random, int primitives) {
  if (rendering.fragments.empty() || random.below(2) == 0) return;
  Fragment f = rendering.fragments[static_cast<std::size_t>(
      random.below(static_cast<int>(rendering.fragments.size())))];
  const int what = random.below(3);
  if (what == 0) rendering.fragments.erase(rendering.fragments.begin());
  if (what == 1) f.primitive = random.below(primitives);
  if (what > 0) rendering.fragments.push_back(f);
  sort_fragments(rendering);
}

TEST(Completeness, DisagreementsAreThePlainDifferenceOfFragments) {
  const std::size_t pairs = share_of(2000u);
  RandomScenes random(share_seed(21));
  std::size_t differing = 0, total = 0;
  for (std::size_t i = 0; i < pairs; ++i) {
    const Scene scene =
        random.next({10, i % 2 == 0 ? Fixed::kOne / 2 : Fixed::kOne / 512, 4, false});
    const Rendering exact = rasterize(scene, {});
    Rendering rendered = rasterize(scene, random_policy(random));
    damage(rendered, random, static_cast<int>(primitives_of(scene).size()));
    const Result result = compare(scene, {}, exact, rendered, {8});
    const auto expected = plain_difference(exact, rendered);
    ASSERT_EQ(reported(result), expected) << "pair " << i;
    if (!expected.empty()) ++differing;
    total += expected.size();
  }
  std::printf("%zu pairs, %zu of them differ, %zu disagreements\n", pairs, differing, total);
  EXPECT_GT(differing, pairs / 2);
}

// Disagreements come in the order that the results file promises.
TEST(Completeness, DisagreementsAreSorted) {
  RandomScenes random(22);
  for (int i = 0; i < 500; ++i) {
    const Scene scene = random.next({10, Fixed::kOne / 2, 4, false});
    Rendering rendered = rasterize(scene, random_policy(random));
    const Result result = compare(scene, {}, rasterize(scene, {}), rendered, {8});
    const auto key = [](const Disagreement& d) {
      return std::tuple(d.y, d.x, d.primitive, d.kind);
    };
    for (std::size_t d = 1; d < result.disagreements.size(); ++d)
      ASSERT_LE(key(result.disagreements[d - 1]), key(result.disagreements[d]));
  }
}

// What a rendering breaks is the same whatever it is held against: places that two policies both
// disagree with are judged alike.
TEST(Legality, DoesNotDependOnThePolicy) {
  RandomScenes random(share_seed(23));
  long compared = 0, illegal = 0;
  for (int i = 0; i < share_of(4000); ++i) {
    const Scene scene =
        random.next({10, i % 2 == 0 ? Fixed::kOne / 2 : Fixed::kOne / 512, 4, false});
    Rendering rendered = rasterize(scene, random_policy(random));
    damage(rendered, random, static_cast<int>(primitives_of(scene).size()));
    // Place, kind and, of values, the rule -> legal, ruling.
    std::map<std::tuple<int, int, int, DisagreementKind, RuleId>, std::set<std::pair<bool, int>>>
        seen;
    for (int p = 0; p < 4; ++p) {
      const Policy policy = p == 0 ? Policy{} : random_policy(random);
      Result result = compare(scene, policy, rasterize(scene, policy), rendered, {8});
      Result* const results[] = {&result};
      judge(results, Latitude::opengl);
      for (const Disagreement& d : result.disagreements) {
        const bool gap = d.cause == Cause(kInteriorGap);
        const bool value = d.kind == DisagreementKind::value;
        seen[{d.x, d.y, d.primitive, d.kind, value ? d.rule : RuleId::none}].insert(
            {is_legal(d), gap ? 1 : d.ruling});
      }
    }
    for (const auto& [place, judgements] : seen) {
      ASSERT_EQ(judgements.size(), 1u)
          << "scene " << i << " pixel " << std::get<0>(place) << " " << std::get<1>(place)
          << " primitive " << std::get<2>(place) << " " << name_of(std::get<3>(place));
      ++compared;
      illegal += judgements.begin()->first ? 0 : 1;
    }
  }
  EXPECT_GT(compared, least_of(10000));
  EXPECT_GT(illegal, least_of(1000));
}

}  // namespace
}  // namespace edgecase
