// SPDX-License-Identifier: MIT
//
// What OpenGL ES does not have, scene by scene, without a driver: each with the sentence that names
// it, and beside it a scene that OpenGL ES can draw.
#include "reference/es_limits.h"

#include <gmock/gmock.h>

#include "tests/reference/drawings.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

constexpr int kPixel = 256;  // in the units of make_draw
constexpr EsFeatures kAll = {true, true, true, true, true, true, true, true};

Scene scene_of(Primitive primitive, const std::vector<std::pair<int, int>>& positions) {
  Scene scene = blank_scene(8, 8);
  scene.draws = {make_draw(primitive, positions)};
  return scene;
}

Scene triangle() {
  return scene_of(Primitive::triangles, {{0, 0}, {6 * kPixel, 0}, {0, 6 * kPixel}});
}

Scene textured(const Sampler& sampler, TextureFormat format = TextureFormat::rgba32f) {
  Scene scene = triangle();
  auto texture = std::make_shared<Texture>();
  texture->format = format;
  texture->levels = {{1, 1, {1, 1, 1, 1}}};
  scene.textures = {texture};
  scene.draws[0].texture = TextureUse{0, sampler, {}};
  return scene;
}

TEST(EsLimits, WhatOpenGlEsLacksAltogether) {
  EXPECT_EQ(beyond_es(triangle(), kAll), "");
  Scene scene = triangle();
  scene.draws[0].provoking_vertex = ProvokingVertex::first;
  EXPECT_THAT(beyond_es(scene, kAll), HasSubstr("no first vertex convention"));
  scene = scene_of(Primitive::points, {{4 * kPixel, 4 * kPixel}});
  scene.draws[0].provoking_vertex = ProvokingVertex::first;
  EXPECT_EQ(beyond_es(scene, kAll), "");
  scene = triangle();
  scene.details.coordinates = true;
  EXPECT_EQ(beyond_es(scene, kAll), "");
  scene.details.derivatives = true;
  EXPECT_THAT(beyond_es(scene, kAll), HasSubstr("no fine and no coarse derivatives"));
  scene = triangle();
  scene.draws[0].multisampling.enabled = false;
  EXPECT_EQ(beyond_es(scene, kAll), "");
  scene.target.samples = 4;
  EXPECT_THAT(beyond_es(scene, kAll), HasSubstr("cannot switch multisampling off"));
}

TEST(EsLimits, WhatItsTexturesLack) {
  Sampler sampler;
  EXPECT_EQ(beyond_es(textured(sampler), kAll), "");
  sampler.lod_bias = 0.5f;
  EXPECT_THAT(beyond_es(textured(sampler), kAll), HasSubstr("no bias of a sampler's"));
  Scene scene = textured({});
  auto flat = std::make_shared<Texture>(*scene.textures[0]);
  flat->dimensions = 1;
  scene.textures = {flat};
  EXPECT_THAT(beyond_es(scene, kAll), HasSubstr("no one-dimensional textures"));
}

TEST(EsLimits, WhatADriverNeedsAnExtensionFor) {
  const EsFeatures none;
  EsFeatures fbo;
  fbo.float_targets = true;
  EXPECT_THAT(beyond_es(triangle(), none), HasSubstr("GL_EXT_float_blend"));
  EXPECT_EQ(beyond_es(triangle(), fbo), "");
  Scene scene = triangle();
  scene.target.surface = Surface::window;
  EXPECT_EQ(beyond_es(scene, none), "");
  scene.draws[0].interpolation = Interpolation::noperspective;
  EXPECT_THAT(beyond_es(scene, none), HasSubstr("GL_NV_shader_noperspective_interpolation"));
  scene = triangle();
  scene.target.depth = DepthFormat::depth16;
  EXPECT_THAT(beyond_es(scene, fbo), HasSubstr("GL_NV_read_depth"));
  scene = triangle();
  scene.target.stencil = StencilFormat::stencil8;
  EXPECT_THAT(beyond_es(scene, fbo), HasSubstr("GL_NV_read_stencil"));
  scene = triangle();
  scene.target.samples = 4;
  EXPECT_THAT(beyond_es(scene, fbo), HasSubstr("GL_OES_sample_variables"));
  fbo.samples = true;
  EXPECT_EQ(beyond_es(scene, fbo), "");
  scene.draws[0].multisampling.min_sample_shading = 1.0f;
  EXPECT_THAT(beyond_es(scene, fbo), HasSubstr("GL_OES_sample_shading"));
}

TEST(EsLimits, WhatADriversTexturesNeedAnExtensionFor) {
  EsFeatures fbo;
  fbo.float_targets = true;
  Sampler nearest;
  nearest.magnify = Filter::nearest;
  EXPECT_EQ(beyond_es(textured(nearest), fbo), "");
  EXPECT_THAT(beyond_es(textured({}), fbo), HasSubstr("GL_OES_texture_float_linear"));
  EXPECT_EQ(beyond_es(textured({}, TextureFormat::rgba8), fbo), "");
  nearest.wrap[1] = Wrap::clamp_to_border;
  EXPECT_THAT(beyond_es(textured(nearest), fbo), HasSubstr("GL_OES_texture_border_clamp"));
  fbo.borders = true;
  EXPECT_EQ(beyond_es(textured(nearest), fbo), "");
  Scene scene = textured({});
  auto generated = std::make_shared<Texture>(*scene.textures[0]);
  generated->generated = true;
  scene.textures = {generated};
  EXPECT_THAT(beyond_es(scene, fbo), HasSubstr("levels of 32-bit floats are not generated"));
}

// The viewport's sides clip none of them (ES 3.2, 12.5), so they are drawn, and judged so.
TEST(EsLimits, PointsAndLinesMayLeaveTheViewport) {
  for (const int x : {-1, 0, 8 * kPixel + 1})
    EXPECT_EQ(beyond_es(scene_of(Primitive::points, {{x, 4 * kPixel}}), kAll), "") << x;
  const Scene line = scene_of(Primitive::line_strip, {{kPixel, kPixel}, {4 * kPixel, 9 * kPixel}});
  EXPECT_EQ(beyond_es(line, kAll), "");
  const Scene triangle =
      scene_of(Primitive::triangles, {{-kPixel, 0}, {99 * kPixel, 0}, {0, 99 * kPixel}});
  EXPECT_EQ(beyond_es(triangle, kAll), "");
}

TEST(EsLimits, OnlyWhatReachesTooFarIsRefused) {
  Scene scene = scene_of(Primitive::points, {{4 * kPixel, 4 * kPixel}});
  Vertex& vertex = scene.draws[0].vertices[0];
  vertex.clip = ClipPosition{-2.5f, 0, 0, 2};
  EXPECT_EQ(beyond_es(scene, kAll), "");
  // Beyond the near plane, and behind the eye, both APIs drop it.
  vertex.clip = ClipPosition{0, 0, -3, 2};
  EXPECT_EQ(beyond_es(scene, kAll), "");
  vertex.clip = ClipPosition{0, 0, 0, -1};
  EXPECT_EQ(beyond_es(scene, kAll), "");
  vertex.clip = ClipPosition{4096, 0, 0, 1};
  EXPECT_THAT(beyond_es(scene, kAll), HasSubstr("reach farther than exact coordinates do"));
}

}  // namespace
}  // namespace edgecase
