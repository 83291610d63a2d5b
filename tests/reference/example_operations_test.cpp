// SPDX-License-Identifier: MIT
//
// reference/examples/rasterizer.py on facing and fragment operations, worked out by hand.
#include <gmock/gmock.h>

#include <array>
#include <string>

#include "tests/reference/example.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;

// Quads over whole targets, at this z of -1 to 1.
Draw layer(double z, int width = 1, Color color = {1, 1, 1, 1}) {
  Draw draw = rectangle(0, 0, 256 * width, 256, color);
  for (Vertex& vertex : draw.vertices)
    vertex.z = Fixed::from_raw(static_cast<std::int64_t>(z * static_cast<double>(Fixed::kOne)));
  return draw;
}

std::string drawn(const Draw& draw) {
  Scene scene = blank_scene(3, 2);
  scene.draws = {draw};
  return coverage(render(example(), scene));
}

// Of both windings, the first one counterclockwise; and as strips and fans, of which every triangle
// faces the way of the first one.
TEST(Example, CullsByTheWindingInTheWindow) {
  Draw separate = rectangle(0, 0, 256, 512);
  std::swap(separate.vertices[1], separate.vertices[2]);
  const Draw strip =
      make_draw(Primitive::triangle_strip, {{0, 0}, {256, 0}, {0, 512}, {256, 512}, {0, 768}});
  const Draw fan = make_draw(Primitive::triangle_fan, {{0, 0}, {256, 0}, {256, 512}, {0, 512}});
  const auto culled = [](Draw draw, CullMode mode, FrontFace face = FrontFace::ccw) {
    draw.cull = mode;
    draw.front_face = face;
    return drawn(draw);
  };
  const std::string whole = "#..\n#..\n";
  const std::string none = "...\n...\n";
  // The two triangles of `separate` share the diagonal; the upper one is counterclockwise.
  EXPECT_EQ(culled(separate, CullMode::back), "#..\n...\n");
  EXPECT_EQ(culled(separate, CullMode::front), "...\n#..\n");
  EXPECT_EQ(culled(separate, CullMode::front, FrontFace::cw), "#..\n...\n");
  EXPECT_EQ(culled(separate, CullMode::front_and_back), none);
  for (const Draw& draw : {strip, fan}) {
    EXPECT_EQ(culled(draw, CullMode::none), whole);
    EXPECT_EQ(culled(draw, CullMode::back), whole);
    EXPECT_EQ(culled(draw, CullMode::front), none);
    EXPECT_EQ(culled(draw, CullMode::back, FrontFace::cw), none);
    EXPECT_EQ(culled(draw, CullMode::front_and_back), none);
  }
  Draw point = make_draw(Primitive::points, {{128, 128}});
  EXPECT_EQ(culled(point, CullMode::front_and_back), "...\n#..\n");
}

TEST(Example, DepthTestsCompareStoredValues) {
  Scene scene = blank_scene(1, 1);
  scene.target.depth = DepthFormat::depth16;
  scene.target.clear_depth = 0.5F;
  // 1/2 and what is 2^-17 farther are stored as one value, 32768: of 32767.5 and 32767.99999.
  scene.draws = {layer(1.0 / 65536)};
  DepthTest& test = scene.draws[0].operations.depth;
  const auto hits = [&] { return render(example(), scene).hits; };
  test.function = CompareFunction::greater;
  EXPECT_THAT(hits(), ElementsAre(0));
  test.function = CompareFunction::equal;
  EXPECT_THAT(hits(), ElementsAre(1));
  scene.draws = {layer(-0.5), layer(0.25), layer(-0.75)};
  for (Draw& draw : scene.draws) draw.operations.depth.function = CompareFunction::less;
  Rendering rendering = render(example(), scene);
  EXPECT_EQ(rendering.fragments.size(), 3U);
  EXPECT_THAT(rendering.hits, ElementsAre(2));
  EXPECT_THAT(rendering.depths, ElementsAre(8192 / 65535.0));  // of 8191.875
  scene.draws[2].operations.depth.write = false;
  rendering = render(example(), scene);
  EXPECT_THAT(rendering.hits, ElementsAre(2));
  EXPECT_THAT(rendering.depths, ElementsAre(16384 / 65535.0));  // of 16383.75
  // Turned round, the farthest layer becomes the nearest.
  scene.depth_range = {1, 0};
  EXPECT_THAT(render(example(), scene).hits, ElementsAre(1));
}

TEST(Example, StencilTestsGuardAndCount) {
  Scene scene = blank_scene(1, 1);
  scene.target.depth = DepthFormat::depth24;
  scene.target.stencil = StencilFormat::stencil8;
  scene.target.clear_stencil = 255;
  scene.draws = {layer(0), layer(0.5)};
  StencilFace face{
      CompareFunction::equal,   0x1f, 0x0f, 0x3c, StencilOperation::zero, StencilOperation::invert,
      StencilOperation::replace};
  scene.draws[0].operations.stencil = StencilTest{face, StencilFace{}};
  // 15 compares equal to 255 under 0x0f; of 0x1f, the bits of 0x3c are stored: 0xc3 | 0x1c.
  EXPECT_THAT(render(example(), scene).stencils, ElementsAre(0xdf));
  // The farther layer then fails the depth test: of ~0xdf, the same bits.
  scene.draws[1].operations.stencil = scene.draws[0].operations.stencil;
  scene.draws[1].operations.depth.function = CompareFunction::less;
  Rendering rendering = render(example(), scene);
  EXPECT_THAT(rendering.stencils, ElementsAre((0xdf & ~0x3c) | (0x20 & 0x3c)));
  EXPECT_THAT(rendering.hits, ElementsAre(1));
  EXPECT_EQ(rendering.fragments.size(), 2U);
  // A reference that does not compare leaves depth and colour alone.
  scene.draws[0].operations.stencil->front.reference = 1;
  rendering = render(example(), scene);
  EXPECT_THAT(rendering.stencils, ElementsAre(0xc3));
  EXPECT_THAT(rendering.depths, ElementsAre(1));
  EXPECT_THAT(rendering.hits, ElementsAre(0));
  // Of clockwise triangles, the other face counts.
  scene.draws[0].front_face = FrontFace::cw;
  EXPECT_THAT(render(example(), scene).hits, ElementsAre(1));
}

TEST(Example, StencilOperationsStopOrWrap) {
  Scene scene = blank_scene(1, 1);
  scene.target.stencil = StencilFormat::stencil8;
  scene.draws = {layer(0)};
  const auto after = [&](StencilOperation operation, std::uint8_t stored) {
    StencilFace face;
    face.pass = operation;
    face.reference = 7;
    scene.target.clear_stencil = stored;
    scene.draws[0].operations.stencil = StencilTest{face, face};
    return int{render(example(), scene).stencils.at(0)};
  };
  EXPECT_EQ(after(StencilOperation::keep, 9), 9);
  EXPECT_EQ(after(StencilOperation::zero, 9), 0);
  EXPECT_EQ(after(StencilOperation::replace, 9), 7);
  EXPECT_EQ(after(StencilOperation::invert, 9), 246);
  EXPECT_EQ(after(StencilOperation::incr, 254), 255);
  EXPECT_EQ(after(StencilOperation::incr, 255), 255);
  EXPECT_EQ(after(StencilOperation::incr_wrap, 255), 0);
  EXPECT_EQ(after(StencilOperation::decr, 0), 0);
  EXPECT_EQ(after(StencilOperation::decr_wrap, 0), 255);
}

// Over 51/255, 102/255, 153/255, 204/255, that is a fifth and its multiples.
std::array<int, 4> blended(const Blending& blending, Color color) {
  Scene scene = blank_scene(1, 1);
  scene.target.clear = {0.2F, 0.4F, 0.6F, 0.8F};
  scene.draws = {layer(0, 1, color)};
  scene.draws[0].operations.blending = blending;
  const std::vector<std::uint8_t> pixels = render(example(), scene).pixels;
  return {pixels.at(0), pixels.at(1), pixels.at(2), pixels.at(3)};
}

TEST(Example, BlendsWithEachEquation) {
  using enum BlendFactor;
  const auto both = [](BlendEquation equation, BlendFactor source, BlendFactor destination) {
    return Blending{{equation, source, destination}, {equation, source, destination}, {}};
  };
  constexpr Color kColor{1, 0.5F, 0, 0.5F};
  EXPECT_THAT(blended(both(BlendEquation::add, src_alpha, one_minus_src_alpha), kColor),
              ElementsAre(153, 115, 76, 166));  // 153, 114.75, 76.5 and 165.75
  EXPECT_THAT(blended(both(BlendEquation::subtract, one, one), kColor), ElementsAre(204, 26, 0, 0));
  EXPECT_THAT(blended(both(BlendEquation::reverse_subtract, one, one), kColor),
              ElementsAre(0, 0, 153, 76));  // 76.5
  EXPECT_THAT(blended(both(BlendEquation::min, zero, zero), kColor), ElementsAre(51, 102, 0, 128));
  EXPECT_THAT(blended(both(BlendEquation::max, zero, zero), kColor),
              ElementsAre(255, 128, 153, 204));
}

// Red, green, blue and alpha of each factor, times 255 of a white source.
TEST(Example, BlendsWithEachFactor) {
  const auto factor = [](BlendFactor source) {
    const BlendTerm term{BlendEquation::add, source, BlendFactor::zero};
    return blended({term, term, {0, 0.25F, 0.5F, 0.75F}}, {1, 1, 1, 1});
  };
  EXPECT_THAT(factor(BlendFactor::dst_color), ElementsAre(51, 102, 153, 204));
  EXPECT_THAT(factor(BlendFactor::one_minus_dst_color), ElementsAre(204, 153, 102, 51));
  EXPECT_THAT(factor(BlendFactor::dst_alpha), ElementsAre(204, 204, 204, 204));
  EXPECT_THAT(factor(BlendFactor::one_minus_dst_alpha), ElementsAre(51, 51, 51, 51));
  EXPECT_THAT(factor(BlendFactor::constant_color), ElementsAre(0, 64, 128, 191));
  EXPECT_THAT(factor(BlendFactor::one_minus_constant_color), ElementsAre(255, 191, 128, 64));
  EXPECT_THAT(factor(BlendFactor::constant_alpha), ElementsAre(191, 191, 191, 191));
  EXPECT_THAT(factor(BlendFactor::one_minus_constant_alpha), ElementsAre(64, 64, 64, 64));
  EXPECT_THAT(factor(BlendFactor::src_alpha_saturate), ElementsAre(51, 51, 51, 255));
  EXPECT_THAT(factor(BlendFactor::one_minus_src_color), ElementsAre(0, 0, 0, 0));
}

TEST(Example, MasksKeepComponents) {
  Scene scene = blank_scene(1, 1);
  scene.target.clear = {0.2F, 0.4F, 0.6F, 0.8F};
  scene.draws = {layer(0, 1, {1, 1, 1, 1})};
  scene.draws[0].operations.color_mask = {true, false, true, false};
  const Rendering rendering = render(example(), scene);
  EXPECT_THAT(rendering.pixels, ElementsAre(255, 102, 255, 204));
  EXPECT_THAT(rendering.hits, ElementsAre(1));
}

// A layer on edge to the left sample and beyond the right one passes in one of them.
TEST(Example, TestsEachSampleForItself) {
  Scene scene = blank_scene(1, 1);
  scene.target.samples = 2;
  scene.target.sample_positions = {{Fixed::from_raw(16384), Fixed::from_raw(32768)},
                                   {Fixed::from_raw(49152), Fixed::from_raw(32768)}};
  scene.target.depth = DepthFormat::depth32f;
  scene.target.stencil = StencilFormat::stencil8;
  scene.draws = {layer(0), layer(0, 1, {1, 0, 0, 1})};
  // z runs from -1/2 on the left to 1/2 on the right.
  for (Vertex& vertex : scene.draws[1].vertices)
    vertex.z = Fixed::from_raw(vertex.position.x > Fixed() ? 32768 : -32768);
  scene.draws[1].operations.depth.function = CompareFunction::less;
  StencilFace face;
  face.depth_fail = StencilOperation::invert;
  scene.draws[1].operations.stencil = StencilTest{face, face};
  const Rendering rendering = render(example(), scene);
  EXPECT_THAT(rendering.hits, ElementsAre(2, 1));
  EXPECT_THAT(rendering.depths, ElementsAre(0.375, 0.5));
  EXPECT_THAT(rendering.stencils, ElementsAre(0, 255));
  EXPECT_THAT(rendering.pixels, ElementsAre(255, 128, 128, 255));
}

// 1/2 is 8388607.5 of the codes up to 2^24 - 1, and a unit of offset is one.
TEST(Example, OffsetsDepths) {
  Scene scene = blank_scene(1, 1);
  scene.target.depth = DepthFormat::depth24;
  scene.draws = {layer(0)};
  scene.draws[0].polygon_offset = PolygonOffset{.units = 2.25};
  EXPECT_THAT(render(example(), scene).depths, ElementsAre(8388610.0 / 16777215));
}

}  // namespace
}  // namespace edgecase
