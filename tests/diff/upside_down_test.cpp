// SPDX-License-Identifier: MIT
//
// Answers whose rows stand in the opposite order, and answers that only look so.
#include "diff/upside_down.h"

#include <gtest/gtest.h>

#include <deque>
#include <set>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/coverage/window.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using Names = std::set<std::string>;

Result compared(const Scene& scene, const Rendering& rendered, const Policy& policy = {}) {
  return compare(scene, policy, rasterize(scene, policy), rendered, {8});
}

Result upside_down(const std::string& name) {
  const Scene& scene = scene_named(name);
  return compared(scene, turned_over(rasterize(scene, {})));
}

void judge_all(std::deque<Result>& results) {
  std::vector<Result*> pointers;
  for (Result& result : results) pointers.push_back(&result);
  judge(pointers, Latitude::opengl);
}

// A scene of one point of size 1 in a target of 8 by 8.
Scene point_scene(double x, double y) {
  Scene scene = blank_scene(8, 8);
  const Point place = at(x, y);
  scene.draws = {make_draw(Primitive::points, {&place, 1})};
  return scene;
}

TEST(UpsideDown, TurningOverTwiceChangesNothing) {
  for (const NamedScene& one : named_scenes()) {
    const Rendering exact = rasterize(one.scene, {});
    const Rendering twice = turned_over(turned_over(exact));
    EXPECT_EQ(twice.pixels, exact.pixels) << one.name;
    EXPECT_EQ(twice.hits, exact.hits) << one.name;
    EXPECT_EQ(twice.depths, exact.depths) << one.name;
    EXPECT_EQ(compared(one.scene, twice).disagreements.size(), 0u) << one.name;
    EXPECT_TRUE(is_covered_upside_down(exact, turned_over(exact))) << one.name;
  }
}

TEST(UpsideDown, RowsAreTurnedAndNothingElse) {
  const Scene scene = point_scene(2.5, 1.5);
  const Rendering turned = turned_over(rasterize(scene, {}));
  ASSERT_EQ(turned.fragments.size(), 1u);
  EXPECT_EQ(turned.fragments[0].x, 2);
  EXPECT_EQ(turned.fragments[0].y, 6);
  EXPECT_EQ(turned.hits[turned.pixel_index(2, 6)], 1u);
  EXPECT_EQ(turned.hits[turned.pixel_index(2, 1)], 0u);
}

// By any fragment that stands elsewhere, is another's, or is missing.
TEST(UpsideDown, EveryFragmentMustStandInItsRow) {
  const Scene& scene = scene_named("fan");
  const Rendering exact = rasterize(scene, {});
  const Rendering turned = turned_over(exact);
  for (std::size_t i = 0; i < turned.fragments.size(); ++i) {
    const auto is_covered = [&](auto change) {
      Rendering other = turned;
      change(other.fragments[i]);
      sort_fragments(other);
      return is_covered_upside_down(exact, other);
    };
    EXPECT_FALSE(is_covered([](Fragment& f) { f.y += 1; }));
    EXPECT_FALSE(is_covered([](Fragment& f) { f.x += 1; }));
    EXPECT_FALSE(is_covered([](Fragment& f) { f.primitive += 1; }));
    EXPECT_FALSE(is_covered([](Fragment& f) { f.coverage = 0; }));
    Rendering fewer = turned;
    fewer.fragments.erase(fewer.fragments.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(is_covered_upside_down(exact, fewer));
    EXPECT_FALSE(is_covered_upside_down(fewer, exact));
  }
}

// Whatever is drawn: no other rule is told where the picture upside down breaks one.
TEST(UpsideDown, ARunIsReportedUnderItsOwnRule) {
  std::deque<Result> run;
  for (const NamedScene& one : named_scenes()) run.push_back(upside_down(one.name));
  judge_all(run);
  std::size_t violations = 0;
  for (const Result& result : run) {
    if (result.disagreements.empty()) continue;
    EXPECT_EQ(rules_of(result), Names{name_of(kWindowOrigin)});
    EXPECT_EQ(disagreement_causes_of(result), Names{name_of(kWindowOrigin)});
    EXPECT_EQ(result.verdict, Verdict::violation);
    for (const Disagreement& d : result.disagreements) {
      EXPECT_EQ(d.ruling, kRulingOnOrigin);
      EXPECT_NE(find_ruling(d.ruling), nullptr);
      EXPECT_NE(d.explanation.find("Ruling 43"), std::string::npos);
    }
    ++violations;
  }
  EXPECT_GE(violations, named_scenes().size() / 2);
}

TEST(UpsideDown, AgreeingCasesThatWouldNotAgreeSpeakAgainstIt) {
  const Scene& other = scene_named("two lines");
  std::deque<Result> run = {upside_down("fan")};
  judge_all(run);
  EXPECT_EQ(rules_of(run[0]), Names{name_of(kWindowOrigin)});
  run.push_back(compared(other, rasterize(other, {})));
  judge_all(run);
  EXPECT_FALSE(rules_of(run[0]).contains(name_of(kWindowOrigin)));
  EXPECT_FALSE(disagreement_causes_of(run[0]).contains(name_of(kWindowOrigin)));
  EXPECT_EQ(run[1].verdict, Verdict::agree);
}

// What was told is forgotten under another reading, word for word.
TEST(UpsideDown, JudgingAgainTellsWhatTheRunSaysNow) {
  const Scene& other = scene_named("two lines");
  std::deque<Result> once = {upside_down("fan"), compared(other, rasterize(other, {}))};
  judge_all(once);
  std::deque<Result> again = {upside_down("fan")};
  judge_all(again);
  // Whoever holds a case against its expectation alone finds what the run finds.
  EXPECT_EQ(again[0].fingerprint, once[0].fingerprint);
  again.push_back(compared(other, rasterize(other, {})));
  judge_all(again);
  EXPECT_EQ(again[0].fingerprint, once[0].fingerprint);
  ASSERT_EQ(again[0].disagreements.size(), once[0].disagreements.size());
  for (std::size_t i = 0; i < once[0].disagreements.size(); ++i) {
    const Disagreement& a = again[0].disagreements[i];
    const Disagreement& b = once[0].disagreements[i];
    EXPECT_EQ(a.rule, b.rule);
    EXPECT_EQ(a.cause, b.cause);
    EXPECT_EQ(a.legality, b.legality);
    EXPECT_EQ(a.ruling, b.ruling);
    EXPECT_EQ(a.explanation, b.explanation);
    EXPECT_FALSE(a.upright);
  }
}

// On a row's border in the middle of the target the rule is open, and alone it proves nothing.
TEST(UpsideDown, WhatIsLegalAsItStandsDoesNotSpeakForIt) {
  const Scene tie = point_scene(2.5, 4), clear = point_scene(2.5, 1.5);
  std::deque<Result> run = {compared(tie, turned_over(rasterize(tie, {})))};
  ASSERT_FALSE(run[0].disagreements.empty());
  EXPECT_TRUE(is_noted_upside_down(run[0]));
  judge_all(run);
  EXPECT_EQ(run[0].verdict, Verdict::convention);
  EXPECT_EQ(rules_of(run[0]), Names{"point.ownership"});
  run.push_back(compared(clear, turned_over(rasterize(clear, {}))));
  judge_all(run);
  EXPECT_EQ(rules_of(run[0]), Names{name_of(kWindowOrigin)});
  EXPECT_EQ(rules_of(run[1]), Names{name_of(kWindowOrigin)});
}

// One that is a row too low looks mirrored in the middle, and nowhere else.
TEST(UpsideDown, ARowTooLowIsNotUpsideDown) {
  std::deque<Result> run;
  for (const double y : {4.5, 2.5, 5.5}) {
    const Scene scene = point_scene(2.5, y);
    Rendering rendered = rasterize(point_scene(2.5, y - 1), {});
    run.push_back(compared(scene, rendered));
  }
  EXPECT_TRUE(is_noted_upside_down(run[0]));
  EXPECT_FALSE(is_noted_upside_down(run[1]));
  judge_all(run);
  for (const Result& result : run) EXPECT_EQ(rules_of(result), Names{"point.ownership"});
}

// Nothing but the rows may differ.
TEST(UpsideDown, AFaultBesideItIsNotHidden) {
  const Scene& scene = scene_named("fan");
  Rendering rendered = turned_over(rasterize(scene, {}));
  rendered.pixels[0] = static_cast<std::uint8_t>(rendered.pixels[0] + 100);
  EXPECT_FALSE(is_noted_upside_down(compared(scene, rendered)));
  Rendering colored = turned_over(rasterize(scene, {}));
  colored.fragments[0].color[0] = colored.fragments[0].color[0] > 0.5 ? 0 : 1;
  EXPECT_FALSE(is_noted_upside_down(compared(scene, colored)));
}

TEST(UpsideDown, IsTheLastOfWhatIsRefuted) {
  AlternativeSet refuted;
  refuted.add({kWindowOrigin});
  const std::string text = text_of_refuted(refuted);
  EXPECT_EQ(text.find('1'), text.size() - 1);
  EXPECT_EQ(parse_refuted(text), refuted);
}

}  // namespace
}  // namespace edgecase
