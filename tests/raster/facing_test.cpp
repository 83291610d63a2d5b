// SPDX-License-Identifier: MIT
//
// Culling: which triangles make no fragments, under which choices, and what is said of them.
#include "raster/coverage_stages.h"

#include <gtest/gtest.h>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "tests/raster/operation_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/causes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

Rendering drawn(const Scene& scene, const Choices& rules = {}) {
  Policy policy;
  policy.rules = rules;
  return rasterize(scene, policy);
}

// Counter-clockwise red to the left, clockwise green to the right, a white point above each.
Scene both_ways(CullMode cull, FrontFace front) {
  Scene scene = operation_scene(4, DepthFormat::none, StencilFormat::none);
  Draw points = make_draw(Primitive::points, std::vector<Point>{at(0.5, 3.5), at(2.5, 3.5)});
  for (Vertex& vertex : points.vertices) vertex.color = kWhite;
  Draw line = make_draw(Primitive::lines, std::vector<Point>{at(0.5, 2.5), at(3.5, 2.5)});
  for (Vertex& vertex : line.vertices) vertex.color = kBlue;
  scene.draws = {rectangle({0, 0, 2, 2}, 0.5, kRed),
                 turned_round(rectangle({2, 0, 2, 2}, 0.5, kGreen)), points, line};
  for (Draw& draw : scene.draws) {
    draw.cull = cull;
    draw.front_face = front;
  }
  return scene;
}

constexpr const char* kBoth = "W.W./BBB./RRGG/RRGG/";
constexpr const char* kLeft = "W.W./BBB./RR../RR../";
constexpr const char* kRight = "W.W./BBB./..GG/..GG/";
constexpr const char* kNone = "W.W./BBB./..../..../";

TEST(Facing, CulledTrianglesMakeNoFragments) {
  const std::tuple<CullMode, FrontFace, const char*> expected[] = {
      {CullMode::none, FrontFace::ccw, kBoth},
      {CullMode::none, FrontFace::cw, kBoth},
      {CullMode::back, FrontFace::ccw, kLeft},
      {CullMode::back, FrontFace::cw, kRight},
      {CullMode::front, FrontFace::ccw, kRight},
      {CullMode::front, FrontFace::cw, kLeft},
      {CullMode::front_and_back, FrontFace::ccw, kNone},
      {CullMode::front_and_back, FrontFace::cw, kNone}};
  for (const auto& [cull, front, picture] : expected) {
    const Rendering rendering = drawn(both_ways(cull, front));
    EXPECT_EQ(colors(rendering), picture) << name_of(cull) << " " << name_of(front);
    const std::size_t triangles = picture == kBoth ? 8u : picture == kNone ? 0u : 4u;
    EXPECT_EQ(rendering.fragments.size(), 5 + triangles);
  }
}

TEST(Facing, APolicyChoosesHowTrianglesFace) {
  const auto picture = [](CullMode cull, FrontFace front, FacingMethod method) {
    return colors(drawn(both_ways(cull, front), {{"polygon.facing", name_of(method)}}));
  };
  EXPECT_EQ(picture(CullMode::back, FrontFace::ccw, FacingMethod::reversed), kRight);
  EXPECT_EQ(picture(CullMode::back, FrontFace::cw, FacingMethod::always_ccw), kLeft);
  EXPECT_EQ(picture(CullMode::front_and_back, FrontFace::cw, FacingMethod::not_culled), kBoth);
}

// A target that is seen upside down is no mirror.
TEST(Facing, RowOrderTurnsNothingRound) {
  EXPECT_EQ(colors(drawn(both_ways(CullMode::back, FrontFace::ccw),
                         {{"triangle.row-order", "top-down"}})),
            kLeft);
}

Scene mirrored(Scene scene) {
  const Fixed width = Fixed::from_integer(scene.target.width);
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices) vertex.position.x = width - vertex.position.x;
  return scene;
}

std::size_t count_of(Scene scene, CullMode cull) {
  for (Draw& draw : scene.draws) draw.cull = cull;
  return drawn(scene).fragments.size();
}

// Strips and fans, too; what has no area has no fragments anyway.
TEST(Facing, EveryTriangleHasOneFaceAndAMirrorShowsTheOther) {
  RandomScenes random(87);
  std::size_t fronts = 0, backs = 0;
  for (int round = 0; round < 400; ++round) {
    Scene scene = random.next({8, 8192, 3, false});
    std::erase_if(scene.draws, [](const Draw& draw) {
      return kind_of(draw.primitive) != PrimitiveKind::triangle;
    });
    const std::size_t front = count_of(scene, CullMode::back);
    const std::size_t back = count_of(scene, CullMode::front);
    ASSERT_EQ(front + back, count_of(scene, CullMode::none));
    ASSERT_EQ(count_of(scene, CullMode::front_and_back), 0u);
    const Scene mirror = mirrored(scene);
    const auto seen = primitives_of(scene), reflected = primitives_of(mirror);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const auto& p = seen[i].positions;
      const bool has_area = cross(p[0], p[1], p[2]) != 0;
      const bool faces = is_front_facing(seen[i], scene.target, {});
      ASSERT_EQ(is_front_facing(reflected[i], scene.target, {}), has_area && !faces) << round;
    }
    fronts += front;
    backs += back;
  }
  EXPECT_GT(fronts, 2000u);
  EXPECT_GT(backs, 2000u);
}

// All triangles of a strip face one way: they lie on one surface.
TEST(Facing, AStripIsCulledAsAWhole) {
  Scene scene = operation_scene(4, DepthFormat::none, StencilFormat::none);
  scene.draws = {
      make_draw(Primitive::triangle_strip,
                std::vector<Point>{at(0, 0), at(4, 0), at(0, 2), at(4, 2), at(0, 4), at(4, 4)})};
  EXPECT_EQ(count_of(scene, CullMode::back), 16u);
  EXPECT_EQ(count_of(scene, CullMode::front), 0u);
}

// Where the vertices are snapped to, not where they were given, decides.
TEST(Facing, SnappingMayTurnATriangleRound) {
  Scene scene = operation_scene(8, DepthFormat::none, StencilFormat::none);
  // The edge runs up by 1 in 2; the apex lies beside (4, 2), here in 128ths of a pixel.
  const auto facing = [&](double x, double y, const char* snap) {
    const std::vector<Point> positions = {at(0, 0), at(8, 4), at(4 + x / 128, 2 + y / 128)};
    scene.draws = {make_draw(Primitive::triangles, positions)};
    Policy policy;
    policy.rules = {{"triangle.snap", snap}};
    return is_front_facing(primitives_of(scene)[0], scene.target,
                           resolve(policy, Surface::fbo).triangles);
  };
  EXPECT_FALSE(facing(11, 5, "none"));
  EXPECT_TRUE(facing(11, 5, "4-half-even"));  // to 8, 8
  EXPECT_TRUE(facing(3, 2, "none"));
  EXPECT_FALSE(facing(3, 2, "4-half-even"));  // to 0, 0: no area is left
}

TEST(Facing, SamplesOfCulledTrianglesAreNotCovered) {
  for (bool enabled : {true, false}) {
    Scene scene = both_ways(CullMode::back, FrontFace::ccw);
    scene.target.samples = 4;
    for (Draw& draw : scene.draws) draw.multisampling.enabled = enabled;
    const auto primitives = primitives_of(scene);
    const RuleChoices choices = resolve({}, Surface::fbo);
    for (int i : {2, 3})
      EXPECT_EQ(covered_samples(primitives[static_cast<std::size_t>(i)], scene.target,
                                choices.triangles, {}),
                SampleCoverage(4));
    for (const Fragment& fragment : drawn(scene).fragments)
      EXPECT_TRUE(fragment.primitive < 2 || fragment.primitive > 3);
  }
}

TEST(Facing, ExplanationsSayWhyATriangleIsCulled) {
  const Scene scene = both_ways(CullMode::back, FrontFace::ccw);
  const auto why = explain_pixel(scene, {}, 2, 0);
  ASSERT_GE(why.size(), 4u);
  EXPECT_EQ(why[0].rule, "triangle.fill-rule");
  EXPECT_EQ(why[2].rule, "polygon.facing");
  EXPECT_FALSE(why[2].covered);
  EXPECT_EQ(why[2].text,
            "the triangle (4, 0), (2, 0), (4, 2) is culled and makes no fragments: its vertices "
            "run clockwise in the window (area -2 square pixels), front faces are ccw, so that it "
            "faces the back, and cull is back");
  ASSERT_EQ(why[2].figure.marks.size(), 2u);
  EXPECT_EQ(why[2].figure.marks[0].points.size(), 3u);
  EXPECT_EQ(why[2].figure.marks[1].role, MarkRole::sample);
  Policy policy;
  policy.rules = {{"polygon.facing", "reversed"}};
  EXPECT_NE(explain_pixel(scene, policy, 0, 0)[0].text.find(
                "run counter-clockwise in the window (area 2 square pixels), front faces are ccw, "
                "so that it faces the back, and cull is back; as reversed has it: "),
            std::string::npos);
}

}  // namespace
}  // namespace edgecase
