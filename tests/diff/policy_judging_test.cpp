// SPDX-License-Identifier: MIT
//
// Policies that OpenGL judges (latitude `opengl`): what the specification forbids stays a
// violation, however exactly a renderer follows a policy that has it so. The same policy judged by
// itself (latitude `none`) agrees.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "tests/diff/coverage/fragment_changes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

Result of_a_follower(const Scene& scene, const Policy& policy, int bits = 8) {
  return judged(scene, rasterize(scene, policy), policy, bits);
}

// Bresenham's ends, truncated toward zero, make a y-major line of this x-major one.
Scene bresenham_scene() {
  Scene scene = blank_scene(16, 16);
  scene.draws = {make_draw(Primitive::lines, std::vector{at(-.75, 2.5), at(7.25, 10.125)})};
  return scene;
}

Scene wide_scene() {
  Scene scene = blank_scene(16, 16);
  scene.draws = {make_draw(Primitive::lines, std::vector{at(3.5, 3.5), at(11.5, 8.5)})};
  scene.draws[0].line_width = Fixed::from_integer(3);
  return scene;
}

struct Forbidden {
  const char* rule;
  const char* alternative;
  Scene scene;
  std::string broken_rule;
  int ruling;
};

std::vector<Forbidden> forbidden() {
  const auto& named = scene_named;
  return {
      {"triangle.fill-rule", "closed", named("shared edge"), "triangle.shared-edge", 5},
      {"triangle.fill-rule", "open", named("shared edge"), "triangle.shared-edge", 5},
      {"triangle.snap", "4-half-even", named("triangles off the grid"), "triangle.fill-rule", 4},
      {"point.snap", "4-half-even", named("points off the grid"), "point.ownership", 6},
      {"line.algorithm", "bresenham-toward-zero", bresenham_scene(), "line.diamond-exit", 1},
      {"line.algorithm", "walk-floor-to-floor", named("strip x-major"), "line.joint", 14},
      {"line.algorithm", "midpoint", named("strip y-major"), "line.joint", 14},
      {"line.width", "rectangle", wide_scene(), "line.diamond-exit", 12},
      {"attribute.smooth", "major-axis", named("line smooth"), "attribute.smooth", 46},
      {"attribute.provoking-vertex", "first", named("triangle"), "attribute.flat", 8},
  };
}

std::string describe(const Result& result) {
  std::string text = name_of(result.verdict);
  for (const Disagreement& d : result.disagreements)
    text += std::string("\n") + name_of(d.rule) + " " + std::to_string(d.ruling) + " '" +
            text_of(d.cause) + "' " + d.explanation;
  return text.substr(0, 1000);
}

TEST(PolicyJudgedByOpenGl, DoesNotExcuseWhatIsForbidden) {
  for (const Forbidden& one : forbidden()) {
    const std::string choice = std::string(one.rule) + "=" + one.alternative;
    SCOPED_TRACE(choice);
    const Policy policy = policy_with(one.rule, one.alternative);
    const Result result = of_a_follower(one.scene, policy);
    ASSERT_EQ(result.verdict, one.ruling == 46 ? Verdict::contested : Verdict::violation)
        << describe(result);
    ASSERT_FALSE(result.disagreements.empty());
    EXPECT_FALSE(result.fingerprint.empty());
    EXPECT_TRUE(result.evidence.empty()) << "the renderer draws what the policy says";
    int of_the_rule = 0;
    for (const Disagreement& d : result.disagreements) {
      EXPECT_TRUE(d.policy_agrees) << describe(result);
      EXPECT_FALSE(is_legal(d)) << describe(result);
      EXPECT_EQ(d.cause, choice) << describe(result);
      if (d.rule == one.broken_rule) {
        ++of_the_rule;
        EXPECT_EQ(d.ruling, one.ruling) << describe(result);
      }
      if (d.kind != DisagreementKind::value) {
        EXPECT_EQ(d.rule, one.broken_rule);
        EXPECT_NE(d.explanation.find("The policy has it as the renderer does."), std::string::npos);
      }
    }
    EXPECT_GT(of_the_rule, 0) << describe(result);
  }
}

// What is made of a line's values is contested where they are: gl_FragCoord.z and .w, derivatives.
TEST(PolicyJudgedByOpenGl, ContestsAllThatComesOfAMajorAxis) {
  Scene scene = scene_named("line smooth");
  scene.details.coordinates = scene.details.derivatives = true;
  scene.draws[0].vertices[0].w = 4;
  const Result result =
      judged(scene, rasterize(scene, policy_with("attribute.smooth", "major-axis")));
  EXPECT_EQ(result.verdict, Verdict::contested) << describe(result);
  std::map<std::string, int> of_each;
  for (const Disagreement& d : result.disagreements) {
    ++of_each[d.explanation.substr(0, d.explanation.find(' '))];
    EXPECT_EQ(d.ruling, 46) << describe(result);
    EXPECT_EQ(d.cause, "attribute.smooth=major-axis") << describe(result);
  }
  for (const char* value : {"gl_FragCoord.z", "gl_FragCoord.w", "dFdx", "dFdyFine", "dFdxCoarse"})
    EXPECT_GT(of_each[value], 0) << value;
}

TEST(PolicyJudgedByItself, AgreesWithWhoFollowsIt) {
  for (const Forbidden& one : forbidden()) {
    Policy policy = policy_with(one.rule, one.alternative);
    policy.latitude = Latitude::none;
    const Result result = of_a_follower(one.scene, policy);
    EXPECT_EQ(result.verdict, Verdict::agree) << one.rule << describe(result);
    EXPECT_TRUE(result.fingerprint.empty());
    const Result standard = judged(one.scene, rasterize(one.scene, {}), policy);
    EXPECT_EQ(standard.verdict, Verdict::violation) << one.rule << describe(standard);
  }
}

// One who draws by the specification differs from such a policy, and is not at fault.
TEST(PolicyJudgedByOpenGl, DoesNotBlameWhoDrawsByTheSpecification) {
  for (const Forbidden& one : forbidden()) {
    if (std::string(one.rule).starts_with("attribute.")) continue;
    const Policy policy = policy_with(one.rule, one.alternative);
    const Result result = judged(one.scene, rasterize(one.scene, {}), policy);
    EXPECT_TRUE(result.verdict == Verdict::convention || result.verdict == Verdict::permitted)
        << one.rule << describe(result);
  }
}

// Each difference is told of the primitive that makes it, with what exact and the renderer have.
TEST(PolicyJudgedByOpenGl, TellsADoublyHitSampleOfTheTriangleThatShouldNotHaveIt) {
  const Scene& scene = scene_named("shared edge");
  const Rendering standard = rasterize(scene, {});
  const auto owner = [&](int x, int y) {
    const auto f = std::find_if(standard.fragments.begin(), standard.fragments.end(),
                                [&](const Fragment& g) { return g.x == x && g.y == y; });
    return f->primitive;
  };
  for (const char* rule : {"closed", "open"}) {
    const bool closed = std::string(rule) == "closed";
    const Result result = of_a_follower(scene, policy_with("triangle.fill-rule", rule));
    std::set<int> columns;
    for (const Disagreement& d : result.disagreements) {
      EXPECT_EQ(d.x, d.y);
      columns.insert(d.x);
      EXPECT_EQ(d.primitive, closed ? 1 - owner(d.x, d.y) : owner(d.x, d.y)) << describe(result);
      EXPECT_EQ(d.kind, closed ? DisagreementKind::extra : DisagreementKind::missing);
      EXPECT_EQ(d.exact, std::vector<double>{closed ? 0. : 1.});
      EXPECT_EQ(d.rendered, std::vector<double>{closed ? 1. : 0.});
    }
    EXPECT_EQ(columns.size(), 10u);
  }
}

// Of a quad through pixel centres, closed edges draw more all round; only the common edge counts.
TEST(PolicyJudgedByOpenGl, TellsNothingOfFreeEdgesBesideASharedOne) {
  Scene scene = blank_scene(16, 16);
  scene.draws = {
      make_draw(Primitive::triangles, std::vector{at(3.5, 3.5), at(12.5, 3.5), at(12.5, 12.5),  //
                                                  at(3.5, 3.5), at(12.5, 12.5), at(3.5, 12.5)})};
  const Result result = of_a_follower(scene, policy_with("triangle.fill-rule", "closed"));
  EXPECT_EQ(result.verdict, Verdict::violation);
  for (const Disagreement& d : result.disagreements) EXPECT_EQ(d.x, d.y) << d.explanation;
}

// The same snap is what a renderer that reports 4 bits has announced.
TEST(PolicyJudgedByOpenGl, ExcusesASnapToTheBitsThatAreReported) {
  for (const auto& [rule, scene] : {std::pair{"triangle.snap", "triangles off the grid"},
                                    std::pair{"point.snap", "points off the grid"}}) {
    const Policy policy = policy_with(rule, "4-half-even");
    EXPECT_EQ(of_a_follower(scene_named(scene), policy, 4).verdict, Verdict::agree);
    EXPECT_EQ(of_a_follower(scene_named(scene), policy, 6).verdict, Verdict::violation);
  }
}

// Closed edges show nothing forbidden on an edge that no triangle shares, nor where no sample lies.
TEST(PolicyJudgedByOpenGl, ExcusesWhatBreaksNoRulingHere) {
  for (const char* rule : {"closed", "open"})
    for (const char* scene : {"triangles with ties", "sliver"})
      EXPECT_EQ(of_a_follower(scene_named(scene), policy_with("triangle.fill-rule", rule)).verdict,
                Verdict::agree);
}

TEST(PolicyJudgedByOpenGl, IsThatOfTheScenesSurface) {
  Policy policy;
  policy.surfaces[Surface::window]["triangle.fill-rule"] = "closed";
  Scene scene = scene_named("shared edge");
  EXPECT_EQ(of_a_follower(scene, policy).verdict, Verdict::agree);
  scene.target.surface = Surface::window;
  const Result result = of_a_follower(scene, policy);
  EXPECT_EQ(result.verdict, Verdict::violation);
  for (const Disagreement& d : result.disagreements) EXPECT_EQ(d.rule, "triangle.shared-edge");
}

// A follower who errs besides has both told, each as what it is.
TEST(PolicyJudgedByOpenGl, TellsOtherFaultsBesideIt) {
  const Scene& scene = scene_named("shared edge");
  const Policy policy = policy_with("triangle.fill-rule", "closed");
  Fragments fragments = rasterize(scene, policy).fragments;
  std::erase_if(fragments, [](const Fragment& f) { return f.x == 9 && f.y == 5; });
  const Result result = judged(scene, compose(scene, fragments), policy);
  EXPECT_EQ(result.verdict, Verdict::violation);
  int others = 0;
  for (const Disagreement& d : result.disagreements) {
    others += d.policy_agrees ? 0 : 1;
    EXPECT_FALSE(is_legal(d));
    EXPECT_EQ(d.policy_agrees, d.x == d.y);
  }
  EXPECT_EQ(others, 1);
  EXPECT_EQ(result.disagreements.size(), 11u);
}

bool has_lines(const Scene& scene) {
  return std::any_of(scene.draws.begin(), scene.draws.end(),
                     [](const Draw& d) { return kind_of(d.primitive) == PrimitiveKind::line; });
}

// Whatever the policy, OpenGL's judgement of its follower is the one under the plain policy. Lines
// may fare worse: they are read as the policy moves them, and not as it suits them best.
TEST(PolicyJudgedByOpenGl, NeverLetsThroughWhatThePlainPolicyFaults) {
  RandomScenes random(71);
  int faulted = 0;
  const std::vector<Choices> choices = {
      {{"triangle.fill-rule", "closed"}},
      {{"triangle.fill-rule", "open"}, {"subpixel.snap", "8-half-even"}},
      {{"subpixel.snap", "4-truncate"}},
      {{"line.algorithm", "bresenham-toward-zero"}},
      {{"line.algorithm", "walk-floor-to-floor"}, {"attribute.smooth", "major-axis"}},
      {{"attribute.provoking-vertex", "first"}, {"line.algorithm", "parallelogram"}}};
  for (int i = 0; i < 1200 && !HasFailure(); ++i) {
    const Scene scene = random.next({10, i / 6 % 2 == 0 ? Fixed::kOne / 2 : 96, 4, true});
    Policy policy;
    policy.rules = choices[static_cast<std::size_t>(i) % choices.size()];
    const Rendering rendered = rasterize(scene, policy);
    const bool plain = judged(scene, rendered).verdict >= Verdict::contested;
    const Result own = of_a_follower(scene, policy);
    EXPECT_TRUE(own.verdict >= Verdict::contested || own.verdict == Verdict::agree);
    if (plain || !has_lines(scene)) {
      EXPECT_EQ(own.verdict >= Verdict::contested, plain) << i << "\n" << describe(own);
    }
    faulted += plain ? 1 : 0;
  }
  EXPECT_GT(faulted, 200);
}

}  // namespace
}  // namespace edgecase
