// SPDX-License-Identifier: MIT
//
// Joints wherever they may lie: at every place of a pixel and its diamond, in all directions, as
// strips and as lines of their own, with and without a middle segment that draws nothing. What is
// doubled or missing there is a violation by ruling 14; what the diamond-exit rule draws under any
// tie order is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "raster/rasterizer.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"
#include "tests/diff/coverage/fragment_changes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"
#include "tests/support/points.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

struct Offset {
  double x = 0;
  double y = 0;
};

// From the joint back to the start, and on to the end, for lines to the right.
constexpr std::array<std::array<Offset, 2>, 3> kShapes = {
    {{{{-5, -1.25}, {5, 2.25}}}, {{{-5, 2}, {5, 0}}}, {{{-4, -4}, {5, -3.5}}}}};

// To the right, to the left, up, down. A y-major line must not be diagonal.
Offset turned(Offset o, int direction) {
  if (direction == 1) return {-o.x, o.y};
  if (direction == 2) return {o.y, o.x * 1.125};
  if (direction == 3) return {o.y, -o.x * 1.125};
  return o;
}

Point beyond(Point p, Offset o) {
  const Point by = at(o.x, o.y);
  return {p.x + by.x, p.y + by.y};
}

enum class Form { strip, separate_lines };
enum class Middle { none, empty };

struct Joint {
  int i = 0;  // place in the pixel, eighths
  int j = 0;
  int direction = 0;
  std::size_t shape = 0;
  Form form = Form::strip;
  Middle middle = Middle::none;
};

Scene scene_of(const Joint& joint) {
  const Point start = at(8 + joint.i / 8., 8 + joint.j / 8.);
  std::vector<Point> points = {beyond(start, turned(kShapes[joint.shape][0], joint.direction)),
                               start};
  if (joint.middle == Middle::empty)
    points.push_back(beyond(start, turned({1. / 16, 0}, joint.direction)));
  points.push_back(beyond(points.back(), turned(kShapes[joint.shape][1], joint.direction)));
  Scene scene = blank_scene(16, 16);
  if (joint.form == Form::strip) {
    scene.draws = {make_draw(Primitive::line_strip, points)};
    return scene;
  }
  std::vector<Point> ends;
  for (std::size_t p = 1; p < points.size(); ++p)
    ends.insert(ends.end(), {points[p - 1], points[p]});
  scene.draws = {make_draw(Primitive::lines, ends)};
  return scene;
}

template <class Visit>
void each_joint(Visit visit) {
  for (int i : {0, 2, 3, 4, 6, 7})
    for (int j : {0, 2, 3, 4, 6, 7})
      for (int direction = 0; direction < 4; ++direction)
        for (std::size_t shape = 0; shape < kShapes.size(); ++shape)
          for (Form form : {Form::strip, Form::separate_lines})
            for (Middle middle : {Middle::none, Middle::empty})
              visit(Joint{i, j, direction, shape, form, middle});
}

bool draws_nothing(const Rendering& rendering, int primitive) {
  return std::none_of(rendering.fragments.begin(), rendering.fragments.end(),
                      [&](const Fragment& f) { return f.primitive == primitive; });
}

std::string describe(const Joint& joint, std::string_view wrong) {
  return std::string(wrong) + " at " + std::to_string(joint.i) + "/8, " + std::to_string(joint.j) +
         "/8, direction " + std::to_string(joint.direction) + ", shape " +
         std::to_string(joint.shape) + (joint.form == Form::strip ? ", strip" : ", lines") +
         (joint.middle == Middle::empty ? ", with a middle" : "");
}

struct JointMutant {
  const char* name;
  void (*change)(const Scene&, Fragments&, int last);  // primitives 0 and `last` meet
};

void double_the_first(const Scene& scene, Fragments& f, int last) {
  const Fragment at = *end_of(scene, f, last, false);
  f.push_back(fragment_at(scene, 0, at.x, at.y));
}

void double_the_last(const Scene& scene, Fragments& f, int last) {
  const Fragment at = *end_of(scene, f, 0, true);
  f.push_back(fragment_at(scene, last, at.x, at.y));
}

void leave_the_first_out(const Scene& scene, Fragments& f, int last) {
  f.erase(end_of(scene, f, last, false));
}

void leave_the_last_out(const Scene& scene, Fragments& f, int) {
  f.erase(end_of(scene, f, 0, true));
}

constexpr std::array<JointMutant, 4> kMutants = {{{"last pixel drawn", double_the_first},
                                                  {"last pixel drawn again", double_the_last},
                                                  {"first missing", leave_the_first_out},
                                                  {"last missing", leave_the_last_out}}};

void expect_broken_joint(const Result& result, const std::string& what) {
  ASSERT_EQ(result.verdict, Verdict::violation) << what;
  ASSERT_FALSE(result.disagreements.empty()) << what;
  for (const Disagreement& d : result.disagreements) {
    ASSERT_FALSE(is_legal(d)) << what;
    ASSERT_EQ(d.rule, "line.joint") << what << ": " << d.explanation;
    ASSERT_EQ(d.ruling, 14) << what;
    ASSERT_NE(d.explanation.find("Ruling 14, for the segment as given: "), std::string::npos);
  }
  ASSERT_FALSE(result.fingerprint.empty()) << what;
}

TEST(JointMutants, AreViolationsWhereverTheJointLies) {
  int broken = 0;
  int with_middle = 0;
  Dealer dealer;
  each_joint([&](const Joint& joint) {
    if (!dealer.deal() || testing::Test::HasFatalFailure()) return;
    const Scene scene = scene_of(joint);
    const Rendering exact = rasterize(scene, {});
    const int last = joint.middle == Middle::empty ? 2 : 1;
    if (last == 2 && !draws_nothing(exact, 1)) return;
    with_middle += last == 2 ? 1 : 0;
    for (const JointMutant& mutant : kMutants) {
      Fragments fragments = exact.fragments;
      mutant.change(scene, fragments, last);
      const Result result = judged(scene, compose(scene, fragments));
      ASSERT_NO_FATAL_FAILURE(expect_broken_joint(result, describe(joint, mutant.name)));
      ++broken;
    }
  });
  std::printf("%d broken joints, %d joints across a middle segment\n", broken, with_middle);
  EXPECT_GT(broken, least_of(5000));
  EXPECT_GT(with_middle, least_of(200));
}

// Both ends of every line drawn: where that is one pixel for both lines, it is drawn twice. Some of
// these lines have two fragments too many, and break ruling 1 before.
TEST(JointMutants, AWalkThatDrawsBothEndsIsAViolationWhereverItDrawsAPixelTwice) {
  Policy walk;
  walk.rules["line.algorithm"] = "walk-floor-to-floor";
  int twice = 0;
  int by_joint = 0;
  each_joint([&](const Joint& joint) {
    if (joint.form == Form::strip || joint.middle == Middle::empty) return;
    if (testing::Test::HasFatalFailure()) return;
    const Scene scene = scene_of(joint);
    const Rendering drawn = rasterize(scene, walk);
    const bool has_two = std::any_of(drawn.hits.begin(), drawn.hits.end(),
                                     [](std::uint32_t hits) { return hits > 1; });
    const Result result = judged(scene, drawn);
    ASSERT_NE(result.verdict, Verdict::agree) << describe(joint, "walk");
    if (!has_two) return;
    ASSERT_EQ(result.verdict, Verdict::violation) << describe(joint, "walk");
    ++twice;
    by_joint +=
        std::any_of(result.disagreements.begin(), result.disagreements.end(),
                    [](const Disagreement& d) { return d.rule == "line.joint" && !is_legal(d); })
            ? 1
            : 0;
  });
  EXPECT_GT(twice, 300);
  EXPECT_GT(by_joint, twice * 3 / 4);
}

TEST(JointMutants, NoTieOrderBreaksAJoint) {
  int differing = 0;
  each_joint([&](const Joint& joint) {
    if (joint.form == Form::strip || testing::Test::HasFatalFailure()) return;
    const Scene scene = scene_of(joint);
    for (const TieRule& ties : all_tie_rules()) {
      if (ties.kind != TieRule::Kind::perturbed) continue;
      Policy policy;
      policy.rules["line.diamond-exit"] = ties.name;
      const Result result = judged(scene, rasterize(scene, policy));
      ASSERT_LE(result.verdict, Verdict::convention) << describe(joint, ties.name);
      differing += result.verdict == Verdict::convention ? 1 : 0;
    }
  });
  EXPECT_GT(differing, 100);
}

}  // namespace
}  // namespace edgecase
