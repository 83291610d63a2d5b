// SPDX-License-Identifier: MIT
//
// Which lines of a scene ruling 14 holds against one another: as given, as snapped, across what
// draws nothing, at borders; and which it leaves alone.
#include "diff/coverage/joint_faults.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "raster/rasterizer.h"
#include "rules/coverage/window.h"
#include "tests/diff/coverage/fragment_changes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

std::vector<JointFault> faults(const Scene& scene, const Rendering& drawn) {
  const auto primitives = primitives_of(scene);
  return joint_faults(primitives, match_coverage(primitives.size(), drawn, drawn), scene);
}

Scene scene_with(Primitive primitive, const std::vector<Point>& points) {
  Scene scene = blank_scene(16, 16);
  scene.draws = {make_draw(primitive, points)};
  return scene;
}

// What exact draws, with one fragment more.
Rendering with(const Scene& scene, int primitive, int x, int y) {
  Fragments fragments = rasterize(scene, {}).fragments;
  fragments.push_back(fragment_at(scene, primitive, x, y));
  return compose(scene, std::move(fragments));
}

// What exact draws, without a primitive's fragments in a column.
Rendering without(const Scene& scene, int primitive, int column) {
  Fragments fragments = rasterize(scene, {}).fragments;
  std::erase_if(fragments,
                [&](const Fragment& f) { return f.primitive == primitive && f.x == column; });
  return compose(scene, std::move(fragments));
}

bool is_illegal_under(const JointFault& fault, const char* snap) {
  return std::find(fault.illegal_snaps.begin(), fault.illegal_snaps.end(), snap) !=
         fault.illegal_snaps.end();
}

const std::vector<Point> kFlat = {at(2.5, 8.5), at(7.5, 8.5), at(12.5, 9.5)};

TEST(JointFaults, NameBothLinesTheClauseAndEverySnap) {
  const Scene scene = scene_with(Primitive::line_strip, kFlat);
  EXPECT_TRUE(faults(scene, rasterize(scene, {})).empty());
  const auto found = faults(scene, with(scene, 0, 7, 8));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, 0);
  EXPECT_EQ(found[0].second, 1);
  EXPECT_EQ(found[0].clause, "pixel (7, 8) is drawn by both segments of a joint");
  EXPECT_EQ(found[0].illegal_snaps.size(), all_snaps().size());
}

TEST(JointFaults, AreFoundInAnyOrderOfDrawing) {
  Scene scene = blank_scene(16, 16);
  scene.draws = {make_draw(Primitive::lines, std::vector{kFlat[1], kFlat[2]}),
                 make_draw(Primitive::points, std::vector{at(1.5, 1.5)}),
                 make_draw(Primitive::lines, std::vector{kFlat[0], kFlat[1]})};
  const auto found = faults(scene, with(scene, 2, 7, 8));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, 2);
  EXPECT_EQ(found[0].second, 0);
}

TEST(JointFaults, PassOverWhatDrawsNothing) {
  // Twice within the diamond of pixel (7, 8), then a line without length.
  const Scene scene = scene_with(
      Primitive::line_strip,
      {at(2.5, 8.5), at(7.375, 8.5), at(7.5, 8.5), at(7.5, 8.5), at(7.625, 8.5), at(12.5, 9.5)});
  EXPECT_TRUE(faults(scene, rasterize(scene, {})).empty());
  for (int missing : {6, 7}) {
    const auto found = faults(scene, without(scene, missing == 6 ? 0 : 4, missing));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].first, 0);
    EXPECT_EQ(found[0].second, 4);
    EXPECT_EQ(found[0].clause, "column " + std::to_string(missing) +
                                   " is empty between the two segments of a joint");
  }
}

// A middle that draws the pixel of the joint is a line as any other.
TEST(JointFaults, HoldAMiddleThatDrawsAgainstBothSides) {
  const Scene scene = scene_with(Primitive::line_strip,
                                 {at(2.5, 8.5), at(7.375, 8.5), at(7.625, 8.5), at(12.5, 9.5)});
  const auto found = faults(scene, with(scene, 1, 7, 8));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, 1);
  EXPECT_EQ(found[0].second, 2);
}

TEST(JointFaults, HoldBothBranchesOfAForkAgainstTheStem) {
  const Scene scene = scene_with(Primitive::lines, {at(2.5, 8.5), at(7.5, 8.5), at(7.5, 8.5),
                                                    at(12.5, 9.5), at(7.5, 8.5), at(12.5, 7.5)});
  EXPECT_TRUE(faults(scene, rasterize(scene, {})).empty()) << "the branches share a pixel";
  const auto found = faults(scene, with(scene, 0, 7, 8));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].second, 1);
  EXPECT_EQ(found[1].second, 2);
}

TEST(JointFaults, LeaveTurnsAloneAndLinesFromOnePointAndWideLines) {
  const std::vector<Point> back = {at(2.5, 8.5), at(7.5, 8.5), at(2.5, 9.5)};
  const std::vector<Point> up = {at(2.5, 8.5), at(7.5, 8.5), at(8.5, 13.5)};
  const std::vector<Point> apart = {at(7.5, 8.5), at(12.5, 9.5), at(7.5, 8.5), at(2.5, 8.5)};
  EXPECT_TRUE(faults(scene_with(Primitive::line_strip, back),
                     with(scene_with(Primitive::line_strip, back), 0, 7, 8))
                  .empty());
  EXPECT_TRUE(faults(scene_with(Primitive::line_strip, up),
                     with(scene_with(Primitive::line_strip, up), 0, 7, 8))
                  .empty());
  EXPECT_TRUE(faults(scene_with(Primitive::lines, apart),
                     rasterize(scene_with(Primitive::lines, apart), {}))
                  .empty());
  Scene wide = scene_with(Primitive::line_strip, kFlat);
  wide.draws[0].line_width = Fixed::from_integer(2);
  EXPECT_TRUE(faults(wide, with(wide, 0, 7, 8)).empty());
  // Rounded to 1: a line of width 1.
  wide.draws[0].line_width = at(1.25, 0).x;
  EXPECT_EQ(faults(wide, with(wide, 0, 7, 8)).size(), 1u);
}

TEST(JointFaults, SeeNoGapThatABorderMayHide) {
  const std::vector<Point> low = {at(2.5, .5), at(7.5, .5), at(12.5, .5)};
  const Scene border = scene_with(Primitive::line_strip, low);
  EXPECT_TRUE(faults(border, without(border, 1, 7)).empty());
  EXPECT_EQ(faults(border, with(border, 0, 7, 0)).size(), 1u) << "a duplicate is seen anywhere";
  Scene cut = scene_with(Primitive::line_strip, kFlat);
  EXPECT_EQ(faults(cut, without(cut, 1, 7)).size(), 1u);
  cut.draws[0].scissor = Viewport{0, 8, 16, 8};
  EXPECT_TRUE(faults(cut, without(cut, 1, 7)).empty()) << "row 8 is the scissor's lowest";
  cut.draws[0].scissor = Viewport{0, 7, 16, 8};
  EXPECT_EQ(faults(cut, without(cut, 1, 7)).size(), 1u);
}

// As given, column 7 belongs to the target's lowest row; rounded to 4 bits to the one above.
TEST(JointFaults, OfASnapAloneHaveNoClauseForTheSegmentsAsGiven) {
  const Scene scene = scene_with(Primitive::line_strip,
                                 {at(2.5, 1 - 1. / 64), at(7, 1 - 1. / 64), at(12, 1 + 5. / 64)});
  const auto found = faults(scene, without(scene, 1, 7));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].clause, "");
  EXPECT_FALSE(is_illegal_under(found[0], "none"));
  EXPECT_TRUE(is_illegal_under(found[0], "4-half-even"));
}

// As given both are x-major; rounded to 4 bits the second is y-major, so that the line turns.
TEST(JointFaults, LeaveAloneWhatASnapTurns) {
  const Scene scene = scene_with(Primitive::line_strip, {at(3.5, 7.5), at(8 + 9. / 256, 8.),
                                                         at(11 + 20. / 256, 11 + 10. / 256)});
  const auto found = faults(scene, with(scene, 0, 8, 8));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(is_illegal_under(found[0], "none"));
  EXPECT_TRUE(is_illegal_under(found[0], "8-half-even"));
  EXPECT_FALSE(is_illegal_under(found[0], "4-half-even"));
}

// As given the line turns: no snap makes one line of it.
TEST(JointFaults, LeaveAloneWhatTurnsAsGiven) {
  const Scene scene =
      scene_with(Primitive::line_strip, {at(3.5, 7.5), at(8, 8), at(11, 11 + 1. / 256)});
  const Segment snapped{at(8, 8), at(11, 11)};
  EXPECT_TRUE(snapped.x_major());
  EXPECT_TRUE(faults(scene, with(scene, 0, 8, 8)).empty());
}

// The second leaves the diamond of pixel (7, 8) within 1/64 pixel; rounded to 4 bits it has no
// length, and no direction.
TEST(JointFaults, LeaveAloneWhatASnapTakesTheLengthOf) {
  const Scene scene = scene_with(Primitive::line_strip,
                                 {at(3.5, 8.5), at(8 - 1. / 128, 8.5), at(8 + 1. / 128, 8.5)});
  const auto found = faults(scene, with(scene, 0, 7, 8));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(is_illegal_under(found[0], "none"));
  EXPECT_FALSE(is_illegal_under(found[0], "4-half-even"));
}

// The same past a middle that draws nothing: what is left is not held against the middle.
TEST(JointFaults, LeaveAloneWhatASnapTakesTheLengthOfPastAMiddle) {
  const Scene scene =
      scene_with(Primitive::line_strip,
                 {at(3.5, 8.5), at(7.25, 8.5), at(8 - 1. / 128, 8.5), at(8 + 1. / 128, 8.5)});
  const auto found = faults(scene, with(scene, 0, 7, 8));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].second, 2);
  EXPECT_TRUE(is_illegal_under(found[0], "none"));
  EXPECT_FALSE(is_illegal_under(found[0], "4-half-even"));
}

// A middle without length is passed over, and the lines beside it judged.
TEST(JointFaults, PassOverAMiddleThatASnapTakesTheLengthOf) {
  const Scene scene = scene_with(
      Primitive::line_strip, {at(3.5, 8.5), at(7.5, 8.5), at(7.5 + 1. / 128, 8.5), at(12.5, 8.5)});
  const auto found = faults(scene, without(scene, 2, 7));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].second, 2);
  EXPECT_EQ(found[0].illegal_snaps.size(), all_snaps().size());
}

// Exact under a snap is whole when it is read with that snap: random polylines, forks and loops.
TEST(JointFaults, AreNotFoundInWhatExactDrawsUnderAnySnap) {
  RandomScenes random(51);
  long joints = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<Point> points;
    Point p = at(random.below(6), random.below(14));
    for (int v = 0; v < 8; ++v) {
      points.push_back(p);
      p = {p.x + at(random.below(768) / 256., 0).x,
           p.y + at(0, (random.below(512) - 256) / 256.).y};
    }
    Scene scene = scene_with(i % 2 == 0 ? Primitive::line_strip : Primitive::line_loop, points);
    scene.draws.push_back(
        make_draw(Primitive::lines, std::vector{points[3], at(random.below(16), 15)}));
    for (Snap snap : all_snaps()) {
      Policy policy;
      policy.rules["line.snap"] = name_of(snap);
      for (const JointFault& fault : faults(scene, rasterize(scene, policy))) {
        ASSERT_FALSE(is_illegal_under(fault, name_of(snap).c_str()))
            << i << " " << name_of(snap) << ": " << fault.clause;
        ASSERT_EQ(fault.clause.empty(), !is_illegal_under(fault, "none"));
      }
      ++joints;
    }
  }
  EXPECT_EQ(joints, 400 * static_cast<long>(all_snaps().size()));
}

}  // namespace
}  // namespace edgecase
