// SPDX-License-Identifier: MIT
//
// Depths in the window: the depth range, the polygon offset and the clamp after it, as fragments,
// samples and passes have them.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/rational.h"
#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "tests/raster/operation_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

Rendering drawn(const Scene& scene, const Choices& rules = {}) {
  Policy policy;
  policy.rules = rules;
  return rasterize(scene, policy);
}

// A triangle over the whole target of 2 by 2 pixels whose depth before the depth range is applied
// is x/8 - 1/4 + `base`: x/16 + 3/8 + base/2 in the window.
Scene ramp(DepthFormat format, double base = 0) {
  Scene scene = operation_scene(2, format, StencilFormat::none);
  const std::vector<Point> positions = {at(-2, -2), at(6, -2), at(-2, 6)};
  Draw draw = make_draw(Primitive::triangles, positions);
  for (Vertex& vertex : draw.vertices)
    vertex.z = Fixed::from_raw(
        static_cast<std::int64_t>((vertex.position.x.to_double() / 8 - 0.25 + base) * 65536));
  scene.draws = {draw};
  scene.details.coordinates = true;
  return scene;
}

// To 2^-40, where doubles are known to 2^-48.
double rounded(double depth) {
  return std::ldexp(std::round(std::ldexp(depth, 40)), -40);
}

// Of the lower row, as fragments tell them.
std::array<double, 2> reported_depths(const Rendering& rendering) {
  return {rounded(rendering.fragments.at(0).depth), rounded(rendering.fragments.at(1).depth)};
}

using Depths = std::array<double, 2>;

// --------------------------------------------------------------------------------- depth range

Interval depth_of_vertex(const Scene& scene, std::size_t vertex) {
  return attributes_of(primitives_of(scene).at(0), {}, scene.target).depth.values[vertex];
}

bool is_number(Interval value, double number) {
  return value.low == number && value.high == number;
}

TEST(WindowDepth, ARangeMapsNearAndFar) {
  Scene scene = ramp(DepthFormat::depth24);
  auto& vertices = scene.draws[0].vertices;
  vertices[0].z = Fixed::from_integer(-1);
  vertices[1].z = Fixed::from_integer(0);
  vertices[2].z = Fixed::from_integer(1);
  const std::pair<DepthRange, std::array<double, 3>> expected[] = {
      {{0, 1}, {0, 0.5, 1}},
      {{0.25F, 0.75F}, {0.25, 0.5, 0.75}},
      {{1, 0}, {1, 0.5, 0}},
      {{0.625F, 0.625F}, {0.625, 0.625, 0.625}}};
  for (const auto& [range, depths] : expected) {
    scene.depth_range = range;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_TRUE(is_number(depth_of_vertex(scene, i), depths[i])) << range.near << " " << i;
  }
}

// Of quotients as near as doubles can say, with one rounding alone.
TEST(WindowDepth, ARangeMapsQuotients) {
  Scene scene = ramp(DepthFormat::depth24);
  for (Vertex& vertex : scene.draws[0].vertices) {
    vertex.clip = ClipPosition{0, 0, 1, 3};
    vertex.w = 3;
  }
  scene.depth_range = {0.1F, 0.75F};
  const Rational near = rational_of(0.1F), far = rational_of(0.75F);
  const Rational exact = near + (far - near) * 2 / 3;
  const Interval depth = depth_of_vertex(scene, 0);
  EXPECT_LT(rational_of(depth.low), exact);
  EXPECT_GT(rational_of(depth.high), exact);
  EXPECT_EQ(depth.high, next_above(depth.low));
}

TEST(WindowDepth, FragmentsAndBuffersHaveTheRangesDepth) {
  Scene scene = ramp(DepthFormat::depth32f);
  EXPECT_EQ(reported_depths(drawn(scene)), (Depths{13 / 32.0, 15 / 32.0}));
  scene.depth_range = {0.75F, 0.25F};
  const Rendering rendering = drawn(scene);
  EXPECT_EQ(reported_depths(rendering), (Depths{35 / 64.0, 33 / 64.0}));
  EXPECT_EQ(rounded(rendering.details.at(0).coordinates.value()[2]), 35 / 64.0);
  EXPECT_EQ(rendering.depths[0], 35 / 64.0);
  // A range that is turned round shows what is farther.
  scene.draws.push_back(rectangle({0, 0, 2, 2}, 1, kGreen));
  for (Draw& draw : scene.draws) draw.operations.depth = {CompareFunction::less, true};
  EXPECT_EQ(colors(drawn(scene)), "GG/GG/");
  scene.depth_range = {0.25F, 0.75F};
  EXPECT_EQ(hits(drawn(scene)), "11/11/");
}

// ------------------------------------------------------------------------------ polygon offset

TEST(WindowDepth, AnOffsetAddsSlopeAndUnits) {
  Scene scene = ramp(DepthFormat::depth24);
  scene.draws[0].polygon_offset = PolygonOffset{2, 0, 0};
  EXPECT_EQ(reported_depths(drawn(scene)), (Depths{17 / 32.0, 19 / 32.0}));
  EXPECT_EQ(rounded(drawn(scene).details.at(1).coordinates.value()[2]), 19 / 32.0);
  scene.draws[0].polygon_offset = PolygonOffset{-1, 0, 0};
  EXPECT_EQ(reported_depths(drawn(scene)), (Depths{11 / 32.0, 13 / 32.0}));
  scene.draws[0].polygon_offset = PolygonOffset{8, 0, 0.25F};
  EXPECT_EQ(reported_depths(drawn(scene)), (Depths{21 / 32.0, 23 / 32.0}));
  EXPECT_EQ(reported_depths(drawn(scene, {{"offset.slope", "ignored"}})),
            (Depths{13 / 32.0, 15 / 32.0}));
}

TEST(WindowDepth, AUnitIsAStepOfTheBuffer) {
  for (const auto& [format, step] :
       {std::pair{DepthFormat::depth16, 1 / 65535.0}, {DepthFormat::depth24, 1 / 16777215.0}}) {
    Scene scene = operation_scene(2, format, StencilFormat::none);
    scene.draws = {rectangle({0, 0, 2, 2}, 0.25, kRed)};
    scene.draws[0].operations.depth.write = true;
    const double before = std::round(drawn(scene).depths[0] / step);
    scene.draws[0].polygon_offset = PolygonOffset{0, -3, 0};
    EXPECT_EQ(std::round(drawn(scene).depths[0] / step), before - 3) << name_of(format);
  }
  // Beside 1/4 the floats are 2^-25 apart.
  Scene scene = operation_scene(2, DepthFormat::depth32f, StencilFormat::none);
  scene.draws = {rectangle({0, 0, 2, 2}, 0.25, kRed)};
  scene.draws[0].operations.depth.write = true;
  scene.draws[0].polygon_offset = PolygonOffset{0, 5, 0};
  EXPECT_EQ(drawn(scene).depths[0], 0.25 + 5 * 0x1p-25);
}

// Decals: what is drawn at the depth of a wall passes `less` with a negative offset.
TEST(WindowDepth, AnOffsetLiftsADecalOffItsWall) {
  Scene scene = operation_scene(4, DepthFormat::depth24, StencilFormat::none);
  scene.draws = {rectangle({0, 0, 4, 4}, 0.3125, kBlue), rectangle({1, 1, 2, 2}, 0.3125, kRed)};
  for (Draw& draw : scene.draws) draw.operations.depth = {CompareFunction::less, true};
  EXPECT_EQ(colors(drawn(scene)), "BBBB/BBBB/BBBB/BBBB/");
  scene.draws[1].polygon_offset = PolygonOffset{0, -1, 0};
  EXPECT_EQ(colors(drawn(scene)), "BBBB/BRRB/BRRB/BBBB/");
}

TEST(WindowDepth, DepthsAreClampedOnceTheOffsetIsAdded) {
  for (DepthFormat format : {DepthFormat::depth24, DepthFormat::depth32f}) {
    Scene scene = ramp(format, 0.5);  // 21/32 and 23/32
    scene.draws[0].polygon_offset = PolygonOffset{5, 0, 0};
    const Rendering above = drawn(scene);
    EXPECT_EQ(reported_depths(above), (Depths{31 / 32.0, 1}));
    EXPECT_EQ(above.fragments[1].depth, 1);
    EXPECT_EQ(above.depths[1], 1);
    scene.draws[0].polygon_offset = PolygonOffset{-11, 0, 0};
    const Rendering below = drawn(scene);
    EXPECT_EQ(reported_depths(below), (Depths{0, 1 / 32.0}));
    EXPECT_EQ(below.fragments[0].depth, 0);
    EXPECT_EQ(below.depths[0], 0);
    EXPECT_EQ(below.details.at(0).coordinates.value()[2], 0);
  }
}

TEST(WindowDepth, PointsAndLinesHaveNoOffset) {
  for (Primitive primitive : {Primitive::points, Primitive::lines}) {
    Scene scene = operation_scene(4, DepthFormat::depth24, StencilFormat::none);
    scene.draws = {make_draw(primitive, std::vector<Point>{at(0.5, 0.5), at(3.5, 0.5)})};
    const Rendering without = drawn(scene);
    scene.draws[0].polygon_offset = PolygonOffset{3, 1000, 0};
    const Rendering with = drawn(scene);
    EXPECT_EQ(with.depths, without.depths);
    EXPECT_FALSE(attributes_of(primitives_of(scene)[0], {}, scene.target).clamps_depth);
  }
}

// The depth of a sample is clamped where the sample is, not where its fragment is.
TEST(WindowDepth, EachSampleHasTheOffsetAndAClampOfItsOwn) {
  Scene scene = ramp(DepthFormat::depth32f, 0.5);
  scene.target.samples = 4;
  scene.draws[0].polygon_offset = PolygonOffset{4.5F, 0, 0};
  const Rendering rendering = drawn(scene);
  EXPECT_EQ(reported_depths(rendering), (Depths{15 / 16.0, 1}));
  // Samples at 3/8, 7/8, 1/8 and 5/8: x/16 + 29/32.
  const double expected[2][4] = {{119 / 128.0, 123 / 128.0, 117 / 128.0, 121 / 128.0},
                                 {127 / 128.0, 1, 125 / 128.0, 1}};
  for (int x = 0; x < 2; ++x)
    for (int s = 0; s < 4; ++s)
      EXPECT_EQ(rounded(rendering.depths[rendering.sample_index(x, 0, s)]), expected[x][s])
          << x << " " << s;
}

TEST(WindowDepth, AShadersZeroIsNotOffset) {
  Scene scene = ramp(DepthFormat::depth32f);
  scene.target.samples = 4;
  scene.draws[0].multisampling.mask = 0b1110;
  scene.draws[0].polygon_offset = PolygonOffset{2, 0, 0};
  const Rendering rendering = drawn(scene, {{"sample.depth", "mirrored-x-or-zero"}});
  EXPECT_EQ(rendering.fragments.at(0).depth, 0);
  EXPECT_GT(rendering.depths[rendering.sample_index(0, 0, 1)], 0.5);
}

// Passes are the scene moved: their triangles face as it does, and have its offset.
TEST(WindowDepth, PassesHaveOffsetAndFacing) {
  Scene scene = ramp(DepthFormat::none);
  scene.draws[0].polygon_offset = PolygonOffset{2, 0, 0};
  scene.draws[0].cull = CullMode::back;
  scene.supersampling = {{at(0.25, 0.5), 1}, {at(0.75, 0.25), 3}};
  Scene plain = scene;
  plain.draws[0].polygon_offset.reset();
  const Rendering offset = drawn(scene), without = drawn(plain);
  ASSERT_EQ(offset.passes.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(offset.passes[k].fragments.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(rounded(offset.passes[k].fragments[i].depth),
                rounded(without.passes[k].fragments[i].depth) + 0.125);
  }
  EXPECT_EQ(reported_depths(offset.passes[0]), (Depths{33 / 64.0, 37 / 64.0}));
  EXPECT_EQ(offset.pixels, without.pixels);
  scene.draws[0].cull = CullMode::front;
  for (const Rendering& pass : drawn(scene).passes) EXPECT_TRUE(pass.fragments.empty());
}

// ---------------------------------------------------------------------------- permitted depths

TEST(WindowDepth, PermittedOffsetsHoldAllOpenChoices) {
  Scene scene = ramp(DepthFormat::depth24, 0.25);
  scene.draws[0].vertices[2].z = Fixed::from_integer(1);  // a slope along y, too
  scene.draws[0].polygon_offset = PolygonOffset{1, 100, 0};
  const ScenePrimitive primitive = primitives_of(scene)[0];
  const Interpolant permitted =
      permitted_attributes_of(primitive, {}, scene.target, 1.0 / 256, {0x1p-24, 2 / (0x1p24 - 1)})
          .depth;
  for (OffsetSlope slope : {OffsetSlope::length, OffsetSlope::largest_partial})
    for (OffsetUnit unit : {OffsetUnit::step, OffsetUnit::power, OffsetUnit::two_steps}) {
      RuleChoices choices;
      choices.values.offset = {slope, unit, {}};
      const Interpolant depth = attributes_of(primitive, choices, scene.target).depth;
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(permitted.values[i].low, depth.values[i].low);
        EXPECT_GT(permitted.values[i].high, depth.values[i].high);
      }
    }
  // The slope's length is 0.1, its larger component 0.078.
  EXPECT_LT(permitted.values[0].high - permitted.values[0].low, 0.03);
  scene.draws[0].polygon_offset.reset();
  const Interpolant none =
      permitted_attributes_of(primitives_of(scene)[0], {}, scene.target, 0, 0).depth;
  EXPECT_TRUE(is_number(none.values[0], 0.375));
  // With a depth range of its own, all that two operations on the sum and on the difference of its
  // ends, the scaling and the addition may be off by, 1 part in 10^5 each:
  // 2 (2 * 0.4375 + 3 * 0.046875 + 0.390625) / 10^5.
  scene.depth_range = {0.25F, 0.625F};
  const Interval ranged =
      permitted_attributes_of(primitives_of(scene)[0], {}, scene.target, 0, 0).depth.values[0];
  EXPECT_LT(ranged.low, 0.390625);
  EXPECT_GT(ranged.high, 0.390625);
  EXPECT_LT(ranged.high - ranged.low, 2.813e-5);
  EXPECT_GT(ranged.high - ranged.low, 2.812e-5);
}

TEST(WindowDepth, IntervalsAreClampedAtBothEnds) {
  PrimitiveAttributes attributes;
  EXPECT_EQ(clamped_depth(attributes, {-1, 2}).low, -1);
  attributes.clamps_depth = true;
  const Interval all = clamped_depth(attributes, Interval::everything());
  EXPECT_EQ(all.low, 0);
  EXPECT_EQ(all.high, 1);
  EXPECT_TRUE(is_number(clamped_depth(attributes, {1.5, 2}), 1));
  EXPECT_TRUE(is_number(clamped_depth(attributes, {-2, -1}), 0));
  EXPECT_EQ(clamped_depth(attributes, {0.25, 2}).low, 0.25);
}

}  // namespace
}  // namespace edgecase
