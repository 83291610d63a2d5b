// SPDX-License-Identifier: MIT
//
// Contexts of OpenGL ES against those of OpenGL, driver by driver: what both can draw, they draw
// alike, in fragments, hits, pixels, depths and samples. What OpenGL ES lacks, it says.
#include <gmock/gmock.h>

#include "tests/reference/opengl_test.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

constexpr int kPixel = 256;  // in the units of make_draw

class EsTest : public OpenGlTest {
 protected:
  // The renderer of OpenGL on the same driver.
  ProcessRenderer& desktop() {
    return shared_renderer("egl" + name().substr(std::string("egl-es").size()));
  }

  // Draws it through both APIs.
  void expect_alike(const Scene& scene, const std::string& what) {
    const Outcome es = render_outcome(renderer(), scene);
    const Outcome gl = render_outcome(desktop(), scene);
    const auto* refusal = std::get_if<Failure>(&es);
    if (refusal != nullptr) {
      // A driver without samples, or without such a buffer, is without them here, too.
      const auto* other = std::get_if<Failure>(&gl);
      EXPECT_EQ(refusal->reason, other == nullptr ? "" : other->reason) << what;
      return;
    }
    ASSERT_TRUE(std::holds_alternative<Rendering>(gl)) << what;
    expect_equal(std::get<Rendering>(es), std::get<Rendering>(gl), what);
  }

  std::string refusal_of(const Scene& scene) {
    const Outcome outcome = render_outcome(renderer(), scene);
    const auto* failure = std::get_if<Failure>(&outcome);
    return failure == nullptr ? "" : failure->reason;
  }

  Scene scene_of(Primitive primitive, const std::vector<std::pair<int, int>>& positions) const {
    Scene scene = blank(16, 16);
    scene.draws = {make_draw(primitive, positions)};
    for (std::size_t i = 0; i < scene.draws[0].vertices.size(); ++i)
      scene.draws[0].vertices[i].color[i % 3] = 0.25f;
    return scene;
  }
  Scene triangle() const {
    return scene_of(Primitive::triangles, {{kPixel, kPixel}, {3900, 700}, {1000, 3700}});
  }

 private:
  static void expect_equal(const Rendering& es, const Rendering& gl, const std::string& what) {
    ASSERT_FALSE(es.fragments.empty()) << what;
    EXPECT_EQ(es.hits, gl.hits) << what;
    EXPECT_EQ(es.pixels, gl.pixels) << what;
    EXPECT_EQ(es.depths, gl.depths) << what;
    EXPECT_EQ(es.stencils, gl.stencils) << what;
    EXPECT_EQ(es.sample_pixels, gl.sample_pixels) << what;
    ASSERT_EQ(es.fragments.size(), gl.fragments.size()) << what;
    for (std::size_t i = 0; i < es.fragments.size(); ++i) {
      const Fragment& a = es.fragments[i];
      const Fragment& b = gl.fragments[i];
      EXPECT_EQ(std::tie(a.x, a.y, a.primitive, a.coverage, a.depth, a.color),
                std::tie(b.x, b.y, b.primitive, b.coverage, b.depth, b.color))
          << what << ", fragment " << i;
    }
  }
};

TEST_P(EsTest, PrimitivesAreThoseOfOpenGl) {
  for (int size : {1, 5, 8}) {
    Scene scene = scene_of(Primitive::points, {{1500, 1300}, {2700, 2333}});
    scene.draws[0].point_size = Fixed::from_integer(size);
    if (refusal_of(scene).empty()) expect_alike(scene, "points of " + std::to_string(size));
    scene = scene_of(Primitive::line_strip, {{600, 777}, {3500, 1300}, {1500, 3333}});
    scene.draws[0].line_width = Fixed::from_integer(size);
    if (size == 1 || refusal_of(scene).empty())
      expect_alike(scene, "lines of " + std::to_string(size));
  }
  for (Interpolation interpolation :
       {Interpolation::flat, Interpolation::smooth, Interpolation::noperspective}) {
    Scene scene = triangle();
    scene.draws[0].interpolation = interpolation;
    scene.draws[0].vertices[1].w = 3;
    expect_alike(scene, std::string("triangle, ") + name_of(interpolation));
  }
}

TEST_P(EsTest, BuffersAreThoseOfOpenGl) {
  for (DepthFormat depth : {DepthFormat::depth16, DepthFormat::depth24, DepthFormat::depth32f}) {
    Scene scene = triangle();
    scene.target.depth = depth;
    scene.draws[0].vertices[0].z = Fixed::from_raw(Fixed::kOne / 3);
    expect_alike(scene, name_of(depth));
  }
  Scene scene = triangle();
  scene.target.stencil = StencilFormat::stencil8;
  scene.target.clear_stencil = 7;
  scene.draws[0].operations.stencil = StencilTest();
  scene.draws[0].operations.stencil->front.pass = StencilOperation::incr;
  expect_alike(scene, "stencil");
  scene = triangle();
  scene.depth_range = {0.75f, 0.25f};
  scene.draws[0].operations.blending = Blending();
  scene.draws[0].operations.blending->color = {BlendEquation::reverse_subtract,
                                               BlendFactor::src_alpha, BlendFactor::one};
  expect_alike(scene, "blending and depth range");
}

TEST_P(EsTest, SamplesAreThoseOfOpenGl) {
  for (auto location :
       {AttributeLocation::center, AttributeLocation::centroid, AttributeLocation::sample}) {
    Scene scene = triangle();
    scene.target.samples = 4;
    scene.target.depth = DepthFormat::depth24;
    scene.draws[0].interpolation = Interpolation::smooth;
    scene.draws[0].multisampling.location = location;
    scene.draws[0].multisampling.mask = 0xb;
    expect_alike(scene, name_of(location));
  }
}

TEST_P(EsTest, TexturesAreThoseOfOpenGl) {
  for (TextureFormat format :
       {TextureFormat::rgba8, TextureFormat::srgb8, TextureFormat::rgba32f}) {
    auto texture = std::make_shared<Texture>();
    texture->format = format;
    texture->generated = true;
    texture->levels = {{4, 4, {}}};
    for (int i = 0; i < 64; ++i) texture->levels[0].texels.push_back(static_cast<float>(i * 4));
    Scene scene = triangle();
    scene.textures = {texture};
    scene.details.texture = true;
    TextureUse use;
    use.sampler.minify = Filter::linear;
    use.sampler.mipmap = MipFilter::linear;
    use.sampler.wrap = {Wrap::clamp_to_border, Wrap::mirrored_repeat};
    use.sampler.border = {1, 0.5f, 0, 1};
    scene.draws[0].texture = use;
    scene.draws[0].interpolation = Interpolation::smooth;
    for (Vertex& vertex : scene.draws[0].vertices)
      vertex.texture_coordinates = {static_cast<float>(vertex.position.x.to_double()) / 3,
                                    static_cast<float>(vertex.position.y.to_double()) / 5};
    if (refusal_of(scene).find("GL_OES_texture_float_linear") == std::string::npos)
      expect_alike(scene, name_of(format));
  }
}

TEST_P(EsTest, WhatItLacksItSays) {
  Scene scene = triangle();
  scene.draws[0].provoking_vertex = ProvokingVertex::first;
  EXPECT_THAT(refusal_of(scene), HasSubstr("no first vertex convention"));
  scene = scene_of(Primitive::points, {{kPixel, kPixel}});
  scene.draws[0].vertices[0].clip = ClipPosition{4096, 0, 0, 1};
  EXPECT_THAT(refusal_of(scene), HasSubstr("reach farther than exact coordinates do"));
  EXPECT_EQ(renderer().info().traits.at("provoking_vertices"), "last");
  EXPECT_EQ(renderer().info().traits.at("derivatives"), "plain");
  EXPECT_THAT(renderer().info().version, ::testing::StartsWith("OpenGL ES 3."));
  EXPECT_THAT(renderer().info().traits.at("context"), HasSubstr("OpenGL ES"));
}

INSTANTIATE_TEST_SUITE_P(Everywhere, EsTest,
                         ::testing::ValuesIn(places_of_share(opengl_es_renderer_names(),
                                                             {Surface::fbo, Surface::window})),
                         place_name);

}  // namespace
}  // namespace edgecase
