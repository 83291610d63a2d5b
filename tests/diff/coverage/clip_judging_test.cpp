// SPDX-License-Identifier: MIT
//
// Judging scenes that leave the clip volume (ruling 42): each alternative is named where it is
// planted, what is drawn of things outside is a violation, and exact agrees with itself.
#include <gtest/gtest.h>

#include <algorithm>

#include "diff/coverage/facing_latitude.h"
#include "raster/rasterizer.h"
#include "rules/coverage/clip_volume.h"
#include "tests/diff/output/output_judging.h"
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
    EXPECT_EQ(result.verdict, Verdict::agree) << described(result);
    if (HasFailure()) return;
  }
  EXPECT_GT(clipped, 500);
}

TEST(ClipJudging, IllegalWaysAreNamedAndConvicted) {
  const Scene scene = through_near();
  for (const char* name : {"discarded", "depth-ignored"}) {
    const Result result =
        judge_output(scene, {}, rasterize(scene, policy_with("clip.volume", name)));
    EXPECT_EQ(result.verdict, Verdict::violation) << name;
    EXPECT_EQ(disagreement_causes_of(result), Names{std::string("clip.volume=") + name})
        << described(result);
    EXPECT_EQ(rules_of(result), Names{"clip.volume"});
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
  Policy policy = policy_with("clip.volume", "polygon");
  policy.rules["triangle.snap"] = "4-half-even";
  int conventions = 0;
  for (int round = 0; round < 2400; ++round) {
    const Scene scene = random.scene(Primitive::triangles, 3, kViewport);
    if (!primitives_of(scene).front().is_clipped) continue;
    const Result result = judge_output(scene, {}, rasterize(scene, policy), Latitude::opengl, 4);
    EXPECT_NE(result.verdict, Verdict::violation) << described(result);
    if (HasFailure()) return;
    if (result.verdict != Verdict::convention) continue;
    ++conventions;
    EXPECT_EQ(rules_of(result), Names{"clip.volume"});
  }
  EXPECT_GT(conventions, 30);
}

TEST(ClipJudging, NothingIsDrawnOfPointsAndLinesOutside) {
  Scene point = scene_of(Primitive::points, {{1.5F, 0, 0, 1}});
  point.draws[0].point_size = Fixed::from_integer(8);
  Scene inside = point;
  inside.draws[0].vertices[0] = clip_vertex({1, 0, 0, 1});
  point.draws[0].vertices[0] = clip_vertex({1, 0, 1.001F, 1});
  EXPECT_TRUE(rasterize(point, {}).fragments.empty());
  EXPECT_FALSE(rasterize(inside, {}).fragments.empty());
  const Result drawn = judge_output(point, {}, rasterize(inside, {}));
  EXPECT_EQ(drawn.verdict, Verdict::violation);
  EXPECT_TRUE(rules_of(drawn).contains("clip.volume"));

  const Scene line = scene_of(Primitive::lines, {{-1, 0, 3, 2}, {1, 0, 3, 2}});
  const Scene seen = scene_of(Primitive::lines, {{-1, 0, 2, 2}, {1, 0, 2, 2}});
  EXPECT_TRUE(rasterize(line, {}).fragments.empty());
  const Result beyond = judge_output(line, {}, rasterize(seen, {}));
  EXPECT_EQ(beyond.verdict, Verdict::violation) << described(beyond);
  EXPECT_TRUE(rules_of(beyond).contains("clip.volume"));
}

// The fragments of a point as they are where nothing is clipped: seen through a viewport that is
// three times as wide and as high.
Rendering unclipped(const Scene& point) {
  Scene wide = point;
  wide.viewport = {-kViewport.width, -kViewport.height, 3 * kViewport.width, 3 * kViewport.height};
  for (Vertex& vertex : wide.draws[0].vertices) {
    ClipPosition clip = *vertex.clip;
    clip.x /= 3;
    clip.y /= 3;
    vertex = clip_vertex(clip);
  }
  return rasterize(wide, {});
}

// 13.7: clipping passes a point between near and far, and implementations may discard it where it
// lies outside of the view volume.
TEST(ClipJudging, PointsBeyondTheSidesMayBeDrawnOrNot) {
  Scene point = scene_of(Primitive::points, {{1.5F, 0, 0.5F, 1}});
  point.draws[0].point_size = Fixed::from_integer(6);
  const Rendering drawn = unclipped(point);
  ASSERT_FALSE(drawn.fragments.empty());
  ASSERT_TRUE(rasterize(point, {}).fragments.empty());
  const Result result = judge_output(point, {}, drawn);
  EXPECT_EQ(result.verdict, Verdict::convention) << described(result);
  // A column too many is not covered, whoever discards what.
  Scene larger = point;
  larger.draws[0].point_size = Fixed::from_integer(8);
  const Result beyond = judge_output(point, {}, unclipped(larger));
  EXPECT_EQ(beyond.verdict, Verdict::violation);
  EXPECT_TRUE(rules_of(beyond).contains("point.ownership")) << described(beyond);
  // Farther than far by a hair nothing is passed.
  for (const auto& [z, verdict] :
       {std::pair{1.000005F, Verdict::permitted}, std::pair{1.00002F, Verdict::violation}}) {
    Scene deep = point;
    deep.draws[0].vertices[0] = clip_vertex({1.5F, 0, z, 1});
    Scene shown = point;
    shown.draws[0].vertices[0] = clip_vertex({1.5F, 0, 1, 1});
    Rendering fragments = unclipped(shown);
    EXPECT_EQ(judge_output(deep, {}, fragments).verdict, verdict) << z;
  }
}

// That a polygon of more than three edges carries some mean of its vertices' values (14.6.1), and
// not its plane's, is contested; beyond what they carry is a violation.
TEST(ClipJudging, APolygonsFragmentsLieInTheHullOfItsVertices) {
  Scene scene = through_near();
  const Color colors[] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  for (std::size_t i = 0; i < 3; ++i) scene.draws[0].vertices[i].color = colors[i];
  scene.draws[0].interpolation = Interpolation::smooth;
  const Rendering exact = rasterize(scene, {});
  ASSERT_EQ(judge_output(scene, {}, exact).verdict, Verdict::agree);
  Rendering other = exact;
  other.pixels.clear();
  for (Fragment& f : other.fragments) f.color = {0.25, 0.25, 0.5, 1};
  const Result mean = judge_output(scene, {}, other);
  EXPECT_EQ(mean.verdict, Verdict::contested);
  for (const Disagreement& d : mean.disagreements) EXPECT_EQ(d.ruling, 66) << d.explanation;
  other.fragments.front().color[0] = 1.0001;
  const Result beyond = judge_output(scene, {}, other);
  EXPECT_EQ(beyond.verdict, Verdict::violation);
  EXPECT_EQ(std::ranges::count(beyond.disagreements, 9, &Disagreement::ruling), 1)
      << described(beyond);
  // Off its plane a depth breaks the ruling that is contested, one beyond near and far ruling 9.
  Rendering flat = exact;
  flat.fragments.front().depth = 0.3;
  const Result off = judge_output(scene, {}, flat);
  ASSERT_EQ(off.disagreements.size(), 1U) << described(off);
  EXPECT_EQ(off.disagreements[0].ruling, 44);
  flat.fragments.front().depth = 0.6;
  const Result outside = judge_output(scene, {}, flat);
  ASSERT_EQ(outside.disagreements.size(), 1U) << described(outside);
  EXPECT_EQ(outside.disagreements[0].ruling, 9);
  // A triangle that nothing cuts keeps to its plane.
  Scene whole = scene;
  whole.draws[0].vertices[2] = clip_vertex({0, 2, 0, 2});
  whole.draws[0].vertices[2].color = colors[2];
  Rendering wrong = rasterize(whole, {});
  wrong.pixels.clear();
  wrong.fragments.front().color = {0.25, 0.25, 0.5, 1};
  EXPECT_EQ(judge_output(whole, {}, wrong).verdict, Verdict::violation);
}

// The division by w and the mapping onto the depth range are floating-point operations (2.3.4.1):
// in single precision they may be some units in the last place off, or a little more.
TEST(ClipJudging, DepthsAndInversesOfPointsErrByTheirOperations) {
  Scene scene = scene_of(Primitive::points, {{0.3F, 0.2F, -1.7F, 2.3F}});
  scene.draws[0].point_size = Fixed::from_integer(2);
  scene.details.coordinates = true;
  const Rendering exact = rasterize(scene, {});
  ASSERT_FALSE(exact.fragments.empty());
  EXPECT_EQ(judge_output(scene, {}, exact).verdict, Verdict::agree);
  const auto verdict_off_by = [&](double depth, double inverse) {
    Rendering rendered = exact;
    rendered.pixels.clear();
    for (Fragment& f : rendered.fragments) f.depth += depth;
    for (FragmentDetail& detail : rendered.details) {
      detail.coordinates.value()[2] += depth;
      detail.coordinates.value()[3] += inverse;
    }
    return judge_output(scene, {}, rendered).verdict;
  };
  // z/w is 0.739, the depth 0.130; 1/w is 0.435.
  for (const double ulp : {-1.5e-8, 1.5e-8, -6e-8, 6e-8, -5e-6, 5e-6})
    EXPECT_EQ(verdict_off_by(ulp, 0), Verdict::permitted) << ulp;
  for (const double ulp : {-6e-8, 6e-8, -4e-6, 4e-6})
    EXPECT_EQ(verdict_off_by(0, ulp), Verdict::permitted) << ulp;
  for (const double off : {-2e-5, 2e-5}) {
    EXPECT_EQ(verdict_off_by(off, 0), Verdict::violation) << off;
    EXPECT_EQ(verdict_off_by(0, off), Verdict::violation) << off;
  }
  // Where w is 1 nothing is divided, and 1/w is 1.
  scene = scene_of(Primitive::points, {{0.25F, 0.25F, 0.5F, 1}});
  scene.details.coordinates = true;
  Rendering rendered = rasterize(scene, {});
  ASSERT_FALSE(rendered.details.empty());
  rendered.details[0].coordinates.value()[3] += 1e-6;
  EXPECT_EQ(judge_output(scene, {}, rendered).verdict, Verdict::violation);
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
  // The area that it had before it was clipped has the other sign, and may decide (14.6.1).
  EXPECT_TRUE(facing.may_face_front && facing.may_face_back);
  scene.draws[0].cull = CullMode::back;
  Scene culled = scene;
  culled.draws[0].cull = CullMode::front;
  EXPECT_NE(rasterize(scene, {}).fragments.empty(), rasterize(culled, {}).fragments.empty());
  EXPECT_EQ(judge_output(culled, {}, rasterize(scene, {})).verdict, Verdict::permitted);
  EXPECT_EQ(judge_output(scene, {}, rasterize(culled, {})).verdict, Verdict::permitted);

  // With two vertices behind the eye, or none, both areas have one sign.
  for (const std::vector<ClipPosition>& positions :
       {std::vector<ClipPosition>{{-1, -1, 0, 2}, {2, -1, -2, -0.5F}, {0, 2, -2, -0.5F}},
        std::vector<ClipPosition>{{-1, -1, 0, 2}, {1, -1, 0, 2}, {0, 2, -4, 2}}}) {
    scene = scene_of(Primitive::triangles, positions);
    const FacingLatitude one = permitted_facing(primitives_of(scene).front(), 8);
    EXPECT_NE(one.may_face_front, one.may_face_back);
    scene.draws[0].cull = one.may_face_front ? CullMode::back : CullMode::front;
    culled = scene;
    culled.draws[0].cull = one.may_face_front ? CullMode::front : CullMode::back;
    EXPECT_FALSE(rasterize(scene, {}).fragments.empty());
    EXPECT_TRUE(rasterize(culled, {}).fragments.empty());
    EXPECT_EQ(judge_output(culled, {}, rasterize(scene, {})).verdict, Verdict::violation);
    EXPECT_EQ(judge_output(scene, {}, rasterize(culled, {})).verdict, Verdict::violation);
  }
}

TEST(ClipJudging, WordsTellOfTheVolume) {
  const Scene scene = through_near();
  const Result result =
      judge_output(scene, {}, rasterize(scene, policy_with("clip.volume", "depth-ignored")));
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
