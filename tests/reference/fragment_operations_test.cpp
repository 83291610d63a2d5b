// SPDX-License-Identifier: MIT
//
// Fragment operations on the OpenGL side: which places have which buffers, culling, what hits count
// and what the capture tells, with textures too, and that nothing is left to the next scene.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/reference/operation_scenes.h"
#include "tests/reference/textured_scenes.h"

namespace edgecase {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

class FragmentOperationsTest : public OperationsTest {};

TEST_P(FragmentOperationsTest, EveryPlaceHasTheBuffersThatItIsKnownToHave) {
  std::string found;
  for (DepthFormat depth : {DepthFormat::none, DepthFormat::depth24, DepthFormat::depth32f})
    if (drawn(row(2, depth, StencilFormat::stencil8))) found += std::string(" ") + name_of(depth);
  if (name().starts_with("egl:device")) return;
  if (std::get<1>(GetParam()) == Surface::window) {
    EXPECT_EQ(found, name().starts_with("osmesa") ? " none depth24" : "");
    return;
  }
  // Upon SwiftShader, zink keeps floats where 24 bits were asked for.
  EXPECT_EQ(found, name() == "egl:zink-swiftshader" ? " none depth32f" : " none depth24 depth32f");
}

TEST_P(FragmentOperationsTest, WhatOpenGlDoesNotHaveIsRefused) {
  EXPECT_EQ(refusal_of(row(2, DepthFormat::depth16, StencilFormat::stencil8)),
            "OpenGL has no buffer of depth16 and stencil8");
}

TEST_P(FragmentOperationsTest, ClearedStencilsAreThoseOfTheTarget) {
  for (DepthFormat depth : {DepthFormat::none, DepthFormat::depth24, DepthFormat::depth32f}) {
    for (int stencil : {0, 1, 0xa5, 255}) {
      Scene scene = row(3, depth, StencilFormat::stencil8);
      scene.target.clear_stencil = static_cast<std::uint8_t>(stencil);
      scene.target.clear_depth = 0.25f;
      const auto rendering = drawn(scene);
      if (!rendering) continue;
      EXPECT_THAT(rendering->stencils, ElementsAre(stencil, stencil, stencil));
      for (double cleared : rendering->depths) EXPECT_NEAR(cleared, 0.25, 0x1p-24);
      EXPECT_EQ(rendering->depths.size(), depth == DepthFormat::none ? 0u : 3u);
    }
  }
}

TEST_P(FragmentOperationsTest, CullingDropsTheFacesThatItNames) {
  struct Expected {
    CullMode mode;
    const char* covered;  // by a counter-clockwise and a clockwise triangle, where ccw is front
  };
  constexpr Expected kExpected[] = {{CullMode::none, "##"},
                                    {CullMode::front, ".#"},
                                    {CullMode::back, "#."},
                                    {CullMode::front_and_back, ".."}};
  for (const Expected& expected : kExpected) {
    for (FrontFace front : {FrontFace::ccw, FrontFace::cw}) {
      Scene scene = row(4, DepthFormat::none, StencilFormat::none);
      scene.draws = {flat_rectangle(0, 0, 1, 1, 0), reversed(flat_rectangle(1, 0, 2, 1, 0)),
                     point_at(2, 0), make_draw(Primitive::lines, {{3 * 256, 128}, {4 * 256, 128}})};
      for (Draw& draw : scene.draws) {
        draw.cull = expected.mode;
        draw.front_face = front;
      }
      std::string covered = expected.covered;
      if (front == FrontFace::cw) std::swap(covered[0], covered[1]);
      const Rendering rendering = render(renderer(), scene);
      EXPECT_EQ(coverage(rendering), covered + "##\n") << name_of(expected.mode);
      EXPECT_EQ(hits_beyond(rendering, 0), covered + "##") << name_of(expected.mode);
    }
  }
}

TEST_P(FragmentOperationsTest, EveryTriangleOfAStripFacesTheSameWay) {
  for (CullMode mode : {CullMode::front, CullMode::back}) {
    Scene scene = row(8, DepthFormat::none, StencilFormat::none);
    scene.draws = {
        make_draw(Primitive::triangle_strip, {{0, 0}, {1024, 0}, {0, 256}, {1024, 256}, {0, 512}})};
    scene.draws[0].cull = mode;
    EXPECT_EQ(coverage(render(renderer(), scene)),
              mode == CullMode::back ? "####....\n" : "........\n");
  }
}

// Three layers; the second fails where the depth test says so, the third where the stencil test
// does.
Scene layers(Scene scene) {
  scene.draws = {flat_rectangle(0, 0, 4, 1, 0, {1, 0, 0, 1}),
                 flat_rectangle(0, 0, 4, 1, 0.5, {0, 1, 0, 1}),
                 flat_rectangle(1, 0, 3, 1, -0.5, {0, 0, 1, 0.5f})};
  StencilFace counting;
  counting.depth_fail = counting.pass = StencilOperation::incr;
  scene.draws[0].operations.stencil = StencilTest{counting, counting};
  scene.draws[1].operations.stencil = StencilTest{counting, counting};
  scene.draws[1].operations.depth.function = CompareFunction::less;
  StencilFace testing;
  testing.function = CompareFunction::equal;
  testing.reference = 9;
  testing.fail = StencilOperation::invert;
  scene.draws[2].operations.stencil = StencilTest{testing, testing};
  return scene;
}

TEST_P(FragmentOperationsTest, HitsAreWhatPassesAndFragmentsAreAll) {
  const auto rendering = drawn(layers(row(4, DepthFormat::depth32f, StencilFormat::stencil8)));
  if (!rendering) return;
  EXPECT_THAT(rendering->hits, ElementsAre(1u, 1u, 1u, 1u));
  EXPECT_EQ(coverage(*rendering), "2332\n");
  EXPECT_THAT(rendering->stencils, ElementsAre(2, 0xfd, 0xfd, 2));
  EXPECT_THAT(rendering->depths, Each(0.5));
  EXPECT_THAT(pixel(*rendering, 1, 0), ElementsAre(255, 0, 0, 255));
  // Fragments that fail are told with their depths and colours.
  for (const Fragment& fragment : rendering->fragments) {
    EXPECT_EQ(fragment.depth, fragment.primitive < 2 ? 0.5 : fragment.primitive < 4 ? 0.75 : 0.25);
    EXPECT_EQ(fragment.color[static_cast<std::size_t>(fragment.primitive / 2)], 1);
  }
}

TEST_P(FragmentOperationsTest, CoverageAloneHasTheSameFragments) {
  const Scene scene = layers(row(4, DepthFormat::depth32f, StencilFormat::stencil8));
  if (!drawn(scene)) return;
  const Task task{"test", &scene, true};
  renderer().render({&task, 1}, [&](std::size_t, Outcome outcome) {
    ASSERT_TRUE(std::holds_alternative<Rendering>(outcome));
    EXPECT_EQ(std::get<Rendering>(outcome).fragments.size(), 10u);
  });
}

TEST_P(FragmentOperationsTest, ScissorsComeBeforeTheTests) {
  Scene scene = row(4, DepthFormat::none, StencilFormat::stencil8);
  scene.draws = {flat_rectangle(0, 0, 4, 1, 0)};
  StencilFace face;
  face.pass = StencilOperation::incr;
  scene.draws[0].operations.stencil = StencilTest{face, face};
  scene.draws[0].scissor = Viewport{1, 0, 2, 1};
  const auto rendering = drawn(scene);
  if (!rendering) return;
  EXPECT_THAT(rendering->stencils, ElementsAre(0, 1, 1, 0));
  EXPECT_EQ(rendering->fragments.size(), 2u);
}

TEST_P(FragmentOperationsTest, TexturedDrawsHaveThemToo) {
  Scene scene = row(4, DepthFormat::depth24, StencilFormat::none);
  scene.textures = {texture_of(
      TextureFormat::rgba32f,
      level_of(4, 1, {{0, 0, 0, 1}, {0.2f, 0, 0, 1}, {0.4f, 0, 0, 1}, {0.6f, 0, 0, 1}}))};
  scene.draws = {flat_rectangle(0, 0, 3, 1, 0.25, {0.2f, 0.4f, 0, 1}),
                 flat_rectangle(1, 0, 2, 1, -0.5, {0.2f, 0.4f, 0, 1}),
                 flat_rectangle(0, 0, 4, 1, 0)};
  scene.draws[2].texture = kNearest;
  scene.draws[2].interpolation = Interpolation::smooth;
  for (Vertex& vertex : scene.draws[2].vertices)
    vertex.texture_coordinates = {static_cast<float>(vertex.position.x.to_double()) / 4, 0.5f};
  scene.draws[2].operations.depth.function = CompareFunction::less;
  scene.draws[2].operations.blending =
      Blending{{BlendEquation::add, BlendFactor::one, BlendFactor::one},
               {BlendEquation::max, BlendFactor::one, BlendFactor::one},
               {}};
  for (bool detailed : {false, true}) {
    scene.details.texture = detailed;
    const auto rendering = drawn(scene);
    if (!rendering) return;
    // The texture is hidden where the second rectangle is.
    const int reds[] = {51, 51, 153, 153};
    for (int x = 0; x < 4; ++x) {
      EXPECT_THAT(pixel(*rendering, x, 0), ElementsAre(reds[x], x < 3 ? 102 : 0, 0, 255)) << x;
      EXPECT_EQ(rendering->hits[rendering->pixel_index(x, 0)], x < 3 ? 2u : 1u);
    }
    EXPECT_EQ(coverage(*rendering), "232#\n");
    for (const Fragment& fragment : rendering->fragments) {
      if (fragment.primitive < 4) continue;
      EXPECT_NEAR(fragment.color[0], 0.2 * fragment.x, 1e-6);
    }
  }
}

// All the state there is.
Scene full_of_state(Scene scene) {
  scene = layers(scene);
  scene.target.clear_depth = 0.75f;
  scene.target.clear_stencil = 0xf0;
  scene.depth_range = {1, 0.25f};
  for (Draw& draw : scene.draws) {
    draw.front_face = FrontFace::cw;
    draw.cull = CullMode::front;
    draw.polygon_offset = PolygonOffset{1, 2, 0};
    FragmentOperations& operations = draw.operations;
    operations.stencil->front.write_mask = operations.stencil->back.write_mask = 0x11;
    operations.stencil->front.function = CompareFunction::notequal;
    operations.depth = {CompareFunction::greater, false};
    operations.blending =
        Blending{{BlendEquation::reverse_subtract, BlendFactor::constant_color, BlendFactor::one},
                 {BlendEquation::min, BlendFactor::zero, BlendFactor::zero},
                 {0.5f, 0.25f, 0.125f, 1}};
    operations.color_mask = {false, true, false, false};
  }
  scene.draws[2].cull = CullMode::front_and_back;
  return scene;
}

TEST_P(FragmentOperationsTest, NothingIsLeftToTheNextScene) {
  Scene plain = row(4, DepthFormat::none, StencilFormat::none);
  plain.draws = {make_draw(Primitive::triangles, {{0, 0}, {0, 256}, {1024, 0}}),
                 make_draw(Primitive::triangles, {{100, 50}, {900, 40}, {300, 250}}, {1, 0, 0, 1}),
                 point_at(3, 0, {0, 1, 0, 0.5f})};
  plain.draws[0].interpolation = Interpolation::smooth;
  plain.draws[0].vertices[1].color = {0.25f, 0.5f, 1, 0.75f};
  std::vector<Scene> scenes = {plain};
  for (DepthFormat format : {DepthFormat::depth24, DepthFormat::depth32f}) {
    plain.target.depth = format;
    scenes.push_back(plain);
  }
  plain.target.stencil = StencilFormat::stencil8;
  scenes.push_back(plain);
  plain.target.stencil = StencilFormat::none;
  plain.target.surface = Surface::fbo;
  plain.target.samples = 4;
  scenes.push_back(plain);
  const Scene busy = full_of_state(row(4, DepthFormat::depth32f, StencilFormat::stencil8));
  const Scene busy24 = full_of_state(row(4, DepthFormat::depth24, StencilFormat::stencil8));
  std::vector<Outcome> before;
  for (const Scene& scene : scenes) before.push_back(render_outcome(renderer(), scene));
  const auto busy_before = drawn(busy);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    drawn(busy24);
    const auto again = drawn(busy);
    if (busy_before) expect_same_rendering(*again, *busy_before);
    const Outcome after = render_outcome(renderer(), scenes[i]);
    ASSERT_EQ(after.index(), before[i].index()) << i;
    if (const auto* rendering = std::get_if<Rendering>(&after))
      expect_same_rendering(*rendering, std::get<Rendering>(before[i]));
  }
}

INSTANTIATE_TEST_SUITE_P(OpenGl, FragmentOperationsTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
