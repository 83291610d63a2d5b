// SPDX-License-Identifier: MIT
//
// Judging scenes that leave the clip volume (ruling 42): each alternative is named where it is
// planted, what is drawn of things outside is a violation, and exact agrees with itself.
#include <gtest/gtest.h>

#include "diff/coverage/facing_latitude.h"
#include "raster/rasterizer.h"
#include "rules/coverage/clip_volume.h"
#include "tests/diff/output_judging.h"
#include "tests/raster/clipped_scenes.h"

namespace edgecase {
namespace {

using Names = std::set<std::string>;
constexpr Viewport kViewport{0, 0, 8, 8};

Scene scene_of(Primitive primitive, const std::vector<ClipPosition>& positions) {
  Scene scene = ClippedScenes(1).scene(primitive, 0, kViewport);
  for (const ClipPosition& clip : positions) scene.draws[0].vertices.push_back(clip_vertex(clip));
  return scene;
}

// Two corners in view, and one nearer than near.
Scene through_near() {
  return scene_of(Primitive::triangles, {{-1, -1, 0, 2}, {1, -1, 0, 2}, {0, 2, -4, 2}});
}

TEST(ClipJudging, ExactAgreesWithItself) {
  ClippedScenes random(31);
  int clipped = 0;
  for (int round = 0; round < 600; ++round) {
    const auto kind = static_cast<Primitive>(round % 7);
    Scene scene = random.scene(
        kind, kind == Primitive::lines || kind == Primitive::triangles ? 6 : 5, kViewport);
    if (kind == Primitive::points) scene.draws[0].point_size = Fixed::from_integer(3);
    scene.draws[0].cull = round % 3 == 0 ? CullMode::back : CullMode::none;
    for (const ScenePrimitive& primitive : primitives_of(scene)) clipped += primitive.is_clipped;
    const Result result = judge_output(scene, {}, rasterize(scene, {}));
    EXPECT_EQ(result.verdict, Verdict::agree) << told(result);
    if (HasFailure()) return;
  }
  EXPECT_GT(clipped, 500);
}

TEST(ClipJudging, IllegalWaysAreNamedAndConvicted) {
  const Scene scene = through_near();
  for (const char* name : {"discarded", "depth-ignored"}) {
    const Result result = judge_output(scene, {}, rasterize(scene, policy_of("clip.volume", name)));
    EXPECT_EQ(result.verdict, Verdict::violation) << name;
    EXPECT_EQ(causes_in(result), Names{std::string("clip.volume=") + name}) << told(result);
    EXPECT_EQ(rules_in(result), Names{"clip.volume"});
    for (const Disagreement& d : result.disagreements)
      if (!is_legal(d)) {
        EXPECT_EQ(d.ruling, 42);
      }
  }
}

// A polygon's vertices are multiples of 1/256 where triangle.snap says so; what is drawn of it
// differs from exact, as the two alternatives together have it.
TEST(ClipJudging, PermittedWaysAreConventions) {
  ClippedScenes random(33);
  Policy policy = policy_of("clip.volume", "polygon");
  policy.rules["triangle.snap"] = "4-half-even";
  int conventions = 0;
  for (int round = 0; round < 2400; ++round) {
    const Scene scene = random.scene(Primitive::triangles, 3, kViewport);
    if (!primitives_of(scene).front().is_clipped) continue;
    const Result result = judge_output(scene, {}, rasterize(scene, policy), Latitude::opengl, 4);
    EXPECT_NE(result.verdict, Verdict::violation) << told(result);
    if (HasFailure()) return;
    if (result.verdict != Verdict::convention) continue;
    ++conventions;
    EXPECT_EQ(rules_in(result), Names{"clip.volume"});
  }
  EXPECT_GT(conventions, 30);
}

TEST(ClipJudging, NothingIsDrawnOfPointsAndLinesOutside) {
  Scene point = scene_of(Primitive::points, {{1.5F, 0, 0, 1}});
  point.draws[0].point_size = Fixed::from_integer(8);
  Scene inside = point;
  inside.draws[0].vertices[0] = clip_vertex({1, 0, 0, 1});
  EXPECT_TRUE(rasterize(point, {}).fragments.empty());
  EXPECT_FALSE(rasterize(inside, {}).fragments.empty());
  const Result drawn = judge_output(point, {}, rasterize(inside, {}));
  EXPECT_EQ(drawn.verdict, Verdict::violation);
  EXPECT_EQ(rules_in(drawn), Names{"clip.volume"});

  const Scene line = scene_of(Primitive::lines, {{-1, 0, 3, 2}, {1, 0, 3, 2}});
  const Scene seen = scene_of(Primitive::lines, {{-1, 0, 2, 2}, {1, 0, 2, 2}});
  EXPECT_TRUE(rasterize(line, {}).fragments.empty());
  const Result beyond = judge_output(line, {}, rasterize(seen, {}));
  EXPECT_EQ(beyond.verdict, Verdict::violation) << told(beyond);
  EXPECT_TRUE(rules_in(beyond).contains("clip.volume"));
}

// A line from behind the eye is cut where it enters the volume: one that starts where its mirror
// image through the eye would land is wrong.
TEST(ClipJudging, LinesAreCut) {
  const Scene scene = scene_of(Primitive::lines, {{-1, 0, -2, -1}, {2, 0, 2, 3}});
  const Rendering exact = rasterize(scene, {});
  EXPECT_FALSE(exact.fragments.empty());
  EXPECT_EQ(judge_output(scene, {}, exact).verdict, Verdict::agree);
  const Scene mirrored = scene_of(Primitive::lines, {{-1, 0, -1, 1}, {2, 0, 2, 3}});
  EXPECT_EQ(judge_output(scene, {}, rasterize(mirrored, {})).verdict, Verdict::violation);
}

TEST(ClipJudging, CullingFollowsTheTriangleSeenFromTheEye) {
  // Counter-clockwise in clip space, with a vertex behind the eye.
  Scene scene = scene_of(Primitive::triangles, {{-1, -1, 0, 2}, {1, -1, 0, 2}, {0, -1, -2, -1}});
  const ScenePrimitive triangle = primitives_of(scene).front();
  const FacingLatitude facing = permitted_facing(triangle, 8);
  const bool front = facing.may_face_front;
  EXPECT_NE(facing.may_face_front, facing.may_face_back);
  scene.draws[0].cull = front ? CullMode::back : CullMode::front;
  EXPECT_FALSE(rasterize(scene, {}).fragments.empty());
  Scene culled = scene;
  culled.draws[0].cull = front ? CullMode::front : CullMode::back;
  EXPECT_TRUE(rasterize(culled, {}).fragments.empty());
  EXPECT_EQ(judge_output(culled, {}, rasterize(scene, {})).verdict, Verdict::violation);
  EXPECT_EQ(judge_output(scene, {}, rasterize(culled, {})).verdict, Verdict::violation);
}

TEST(ClipJudging, WordsTellOfTheVolume) {
  const Scene scene = through_near();
  const Result result =
      judge_output(scene, {}, rasterize(scene, policy_of("clip.volume", "depth-ignored")));
  ASSERT_FALSE(result.disagreements.empty());
  const Disagreement& d = result.disagreements.front();
  EXPECT_NE(
      d.explanation.find("reaches out of the clip volume (the third vertex at (0, 2, -4, 2))"),
      std::string::npos)
      << d.explanation;
  EXPECT_NE(d.explanation.find("nearer than near or farther than far"), std::string::npos);
  EXPECT_NE(d.situation.find("clipped triangle"), std::string::npos);
}

}  // namespace
}  // namespace edgecase
