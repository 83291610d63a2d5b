// SPDX-License-Identifier: MIT
//
// Facing and culling (ruling 40): a culled triangle that is drawn, one that is missing, and those
// so thin that they may face either way.
#include <gtest/gtest.h>

#include "diff/coverage/facing_latitude.h"
#include "raster/rasterizer.h"
#include "tests/diff/output/output_judging.h"
#include "tests/raster/operation_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using Names = std::set<std::string>;

// A triangle that runs clockwise, and one counter-clockwise that shares an edge with it.
Scene two_ways(CullMode cull) {
  Scene scene = operation_scene(8, DepthFormat::none, StencilFormat::none);
  Draw draw =
      make_draw(Primitive::triangles,
                std::vector<Point>{at(1, 1), at(1, 7.25), at(7.25, 1),    // clockwise
                                   at(7.25, 1), at(7, 7), at(1, 7.25)});  // counter-clockwise
  draw.cull = cull;
  scene.draws = {draw};
  return scene;
}

TEST(OutputFacing, ACulledTriangleLeavesNoHoleInASharedEdge) {
  for (const CullMode cull : {CullMode::none, CullMode::back, CullMode::front}) {
    const Scene scene = two_ways(cull);
    EXPECT_EQ(judge_output(scene, {}, rasterize(scene, {})).verdict, Verdict::agree);
  }
}

TEST(OutputFacing, ACulledTriangleThatIsDrawnIsAViolation) {
  const Scene scene = two_ways(CullMode::back);
  const Result result = judge_output(scene, {}, rasterize(two_ways(CullMode::none), {}));
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(rules_of(result), Names{"polygon.facing"}) << described(result);
  EXPECT_EQ(disagreement_causes_of(result), Names{"polygon.facing=not-culled"});
  for (const Disagreement& d : result.disagreements) {
    EXPECT_EQ(d.ruling, 40);
    EXPECT_EQ(d.kind, DisagreementKind::extra);
    EXPECT_FALSE(is_legal(d));
  }
}

TEST(OutputFacing, TheWrongTriangleIsDrawn) {
  const Scene scene = two_ways(CullMode::back);
  const Result result = judge_output(scene, {}, rasterize(two_ways(CullMode::front), {}));
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(rules_of(result), Names{"polygon.facing"}) << described(result);
  EXPECT_EQ(disagreement_causes_of(result), Names{"polygon.facing=reversed"});
  Scene clockwise = scene;
  clockwise.draws[0].front_face = FrontFace::cw;
  const Result other = judge_output(clockwise, {}, rasterize(scene, {}));
  EXPECT_EQ(other.verdict, Verdict::violation);
  EXPECT_TRUE(disagreement_causes_of(other) == Names{"polygon.facing=reversed"} ||
              disagreement_causes_of(other) == Names{"polygon.facing=always-ccw"})
      << described(other);
}

// A sliver of 2^-9 pixels high through the centres of a row.
Scene sliver(CullMode cull) {
  Scene scene = operation_scene(8, DepthFormat::none, StencilFormat::none);
  const double part = 1.0 / 1024;
  Draw draw =
      make_draw(Primitive::triangles,
                std::vector<Point>{at(1, 3.5 - part), at(7, 3.5 - part), at(4, 3.5 + part)});
  draw.cull = cull;
  scene.draws = {draw};
  return scene;
}

TEST(OutputFacing, ASliverMayFaceEitherWay) {
  const Scene front = sliver(CullMode::front);
  const Scene back = sliver(CullMode::back);
  const ScenePrimitive triangle = primitives_of(back).front();
  const FacingLatitude facing = permitted_facing(triangle, 8);
  EXPECT_TRUE(facing.may_face_front && facing.may_face_back);
  // Drawn where it should be culled, and the other way round.
  const Rendering drawn = rasterize(sliver(CullMode::none), {});
  const Rendering culled = rasterize(front, {});
  ASSERT_FALSE(drawn.fragments.empty());
  ASSERT_TRUE(culled.fragments.empty());
  Result result = judge_output(front, {}, drawn);
  EXPECT_EQ(result.verdict, Verdict::permitted) << described(result);
  EXPECT_EQ(rules_of(result), Names{"polygon.facing"});
  EXPECT_NE(judge_output(back, {}, culled).verdict, Verdict::violation);
  // With finer vertices it may not.
  result = judge_output(front, {}, drawn, Latitude::opengl, 14);
  EXPECT_EQ(result.verdict, Verdict::violation) << described(result);
}

TEST(OutputFacing, LatitudeByTheSignOfTheArea) {
  Scene scene = two_ways(CullMode::back);
  const auto all = primitives_of(scene);
  for (std::size_t i = 0; i < 2; ++i) {
    const FacingLatitude facing = permitted_facing(all[i], 4);
    EXPECT_EQ(facing.may_face_front, i == 1);
    EXPECT_EQ(facing.may_face_back, i == 0);
    const CullingLatitude culling = permitted_culling(all[i], 4);
    EXPECT_EQ(culling.may_be_culled, i == 0);
    EXPECT_EQ(culling.may_be_drawn, i == 1);
  }
  scene.draws[0].cull = CullMode::front_and_back;
  EXPECT_FALSE(permitted_culling(all[0], 4).may_be_drawn);
  scene.draws[0].cull = CullMode::none;
  EXPECT_FALSE(permitted_culling(all[0], 4).may_be_culled);
}

// The stencil state of either face may hold for the sliver, and of a proper triangle one.
TEST(OutputFacing, TheStencilStateOfEitherFace) {
  for (const bool thin : {true, false}) {
    Scene scene = thin ? sliver(CullMode::none) : two_ways(CullMode::none);
    scene.target.stencil = StencilFormat::stencil8;
    StencilFace front;
    front.pass = StencilOperation::replace;
    front.reference = 3;
    StencilFace back = front;
    back.reference = 7;
    scene.draws[0].operations.stencil = {front, back};
    Scene turned = scene;
    turned.draws[0].operations.stencil = {back, front};
    const Result result = judge_output(scene, {}, rasterize(turned, {}));
    EXPECT_EQ(result.verdict == Verdict::violation, !thin) << described(result);
    if (!thin) {
      EXPECT_EQ(disagreement_causes_of(result), Names{"polygon.facing=reversed"});
    }
  }
}

}  // namespace
}  // namespace edgecase
