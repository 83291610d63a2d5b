// SPDX-License-Identifier: MIT
#include "search/settings.h"
#include "search/scene_size.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "casefile/scene/viewport.h"
#include "model/scene.h"
#include "tests/search/faulty_renderer.h"

namespace edgecase {
namespace {

// A white triangle on a black target: nothing but defaults.
Scene plain_scene() {
  Scene scene = scene_with(
      8, {make_draw(Primitive::triangles,
                    std::array{sixteenths(8, 8), sixteenths(72, 8), sixteenths(8, 72)})});
  for (Vertex& vertex : scene.draws[0].vertices) vertex.color = {1, 1, 1, 1};
  return scene;
}

Sampler& textured(Scene& scene) {
  Texture texture;
  texture.levels = {{1, 1, {1, 1, 1, 1}}};
  scene.textures = {std::make_shared<const Texture>(texture)};
  scene.details.texture = true;
  scene.draws[0].texture = TextureUse();
  scene.draws[0].interpolation = Interpolation::smooth;
  return scene.draws[0].texture->sampler;
}

// A change to a plain scene for each setting, by the setting's name.
const std::map<std::string, void (*)(Scene&)>& changes() {
  static const std::map<std::string, void (*)(Scene&)> all = {
      {"supersampling",
       [](Scene& s) {
         s.supersampling = {{centre_of_pixel(), 1}};
       }},
      {"samples", [](Scene& s) { s.target.samples = 4; }},
      {"depth buffer", [](Scene& s) { s.target.depth = DepthFormat::depth24; }},
      {"stencil buffer", [](Scene& s) { s.target.stencil = StencilFormat::stencil8; }},
      {"texture", [](Scene& s) { textured(s); }},
      {"wrap", [](Scene& s) { textured(s).wrap[1] = Wrap::mirrored_repeat; }},
      {"magnify", [](Scene& s) { textured(s).magnify = Filter::nearest; }},
      {"minify", [](Scene& s) { textured(s).minify = Filter::linear; }},
      {"mipmap", [](Scene& s) { textured(s).mipmap = MipFilter::nearest; }},
      {"lod_bias", [](Scene& s) { textured(s).lod_bias = 1; }},
      {"min_lod", [](Scene& s) { textured(s).min_lod = 1; }},
      {"max_lod", [](Scene& s) { textured(s).max_lod = 1; }},
      {"base_level", [](Scene& s) { textured(s).base_level = 1; }},
      {"max_level", [](Scene& s) { textured(s).max_level = 1; }},
      {"border", [](Scene& s) { textured(s).border[0] = 1; }},
      {"max_anisotropy", [](Scene& s) { textured(s).max_anisotropy = 2; }},
      {"clip coordinates",
       [](Scene& s) {
         Vertex& vertex = s.draws[0].vertices[0];
         vertex.clip = ClipPosition{0, 0, 0, 1};
         vertex.position = {Fixed::from_integer(4), Fixed::from_integer(4)};
       }},
      {"details", [](Scene& s) { s.details.coordinates = true; }},
      {"viewport", [](Scene& s) { s.viewport.width = 32; }},
      {"depth_range", [](Scene& s) { s.depth_range.near = 0.25F; }},
      {"sample_positions", [](Scene& s) { s.target.sample_positions = {centre_of_pixel()}; }},
      {"clear",
       [](Scene& s) {
         s.target.clear = {1, 0, 0, 1};
       }},
      {"clear_depth", [](Scene& s) { s.target.clear_depth = 0.5F; }},
      {"clear_stencil", [](Scene& s) { s.target.clear_stencil = 3; }},
      {"stencil", [](Scene& s) { s.draws[0].operations.stencil = StencilTest(); }},
      {"depth", [](Scene& s) { s.draws[0].operations.depth.function = CompareFunction::less; }},
      {"blend", [](Scene& s) { s.draws[0].operations.blending = Blending(); }},
      {"color_mask", [](Scene& s) { s.draws[0].operations.color_mask[1] = false; }},
      {"polygon_offset", [](Scene& s) { s.draws[0].polygon_offset = PolygonOffset(); }},
      {"cull", [](Scene& s) { s.draws[0].cull = CullMode::back; }},
      {"front_face", [](Scene& s) { s.draws[0].front_face = FrontFace::cw; }},
      {"scissor",
       [](Scene& s) {
         s.draws[0].scissor = Viewport{0, 0, 4, 4};
       }},
      {"line_width", [](Scene& s) { s.draws[0].line_width = Fixed::from_integer(3); }},
      {"point_size", [](Scene& s) { s.draws[0].point_size = Fixed::from_integer(3); }},
      {"interpolation", [](Scene& s) { s.draws[0].interpolation = Interpolation::smooth; }},
      {"provoking_vertex", [](Scene& s) { s.draws[0].provoking_vertex = ProvokingVertex::first; }},
      {"multisample", [](Scene& s) { s.draws[0].multisampling.enabled = false; }},
      {"attribute_location",
       [](Scene& s) { s.draws[0].multisampling.location = AttributeLocation::centroid; }},
      {"min_sample_shading", [](Scene& s) { s.draws[0].multisampling.min_sample_shading = 0.5F; }},
      {"sample_mask", [](Scene& s) { s.draws[0].multisampling.mask = 1; }},
      {"alpha_to_coverage", [](Scene& s) { s.draws[0].multisampling.alpha_to_coverage = true; }},
      {"w", [](Scene& s) { s.draws[0].vertices[0].w = 2; }},
      {"z", [](Scene& s) { s.draws[0].vertices[0].z = Fixed::from_raw(1); }},
      {"colours",
       [](Scene& s) {
         s.draws[0].vertices[0].color = {1, 0, 0, 1};
       }},
  };
  return all;
}

TEST(Settings, OfAPlainSceneAreAllDefault) {
  EXPECT_EQ(count_settings(plain_scene()), 0);
  EXPECT_TRUE(simpler_settings(plain_scene()).empty());
}

// Every one is known by a change that it, and it alone, puts back.
TEST(Settings, EachIsPutBackByItself) {
  for (const Setting& setting : all_settings()) {
    const auto change = changes().find(setting.name);
    ASSERT_NE(change, changes().end()) << setting.name << " has no test";
    Scene scene = plain_scene();
    EXPECT_FALSE(setting.reset(scene, 0)) << setting.name;
    EXPECT_TRUE(same_scene(scene, plain_scene())) << setting.name;
    change->second(scene);
    const Scene changed = scene;
    EXPECT_GE(count_settings(scene), 1) << setting.name;
    EXPECT_TRUE(setting.reset(scene, 0)) << setting.name;
    EXPECT_FALSE(same_scene(scene, changed)) << setting.name;
    EXPECT_FALSE(setting.reset(scene, 0)) << setting.name << " is put back twice";
    EXPECT_LT(size_of(scene), size_of(changed)) << setting.name;
    // What else has changed is put back by all of them.
    for (const Setting& other : all_settings()) other.reset(scene, 0);
    if (setting.name != std::string("clip coordinates")) {
      EXPECT_TRUE(same_scene(scene, plain_scene())) << setting.name;
    }
  }
  EXPECT_EQ(changes().size(), all_settings().size());
}

TEST(Settings, ProposalsTakeAllBackFirstAndThenEach) {
  Scene scene = plain_scene();
  scene.draws.push_back(scene.draws[0]);
  for (Draw& draw : scene.draws) draw.cull = CullMode::back;
  scene.target.clear = {1, 0, 0, 1};
  const std::vector<Scene> simpler = simpler_settings(scene);
  ASSERT_GE(simpler.size(), 5u);
  EXPECT_EQ(count_settings(simpler[0]), 0);
  for (const Scene& proposal : simpler) EXPECT_LT(size_of(proposal), size_of(scene));
  // One draw may need what the other does not.
  EXPECT_TRUE(std::ranges::any_of(simpler, [](const Scene& proposal) {
    return proposal.draws[0].cull == CullMode::none && proposal.draws[1].cull == CullMode::back;
  }));
}

TEST(Settings, WidthsBecomeSmallerWhereTheyCannotGo) {
  Scene scene = plain_scene();
  scene.draws[0].line_width = Fixed::from_raw(21 * Fixed::kOne / 4);
  const auto has = [](const std::vector<Scene>& scenes, Fixed width) {
    return std::ranges::any_of(scenes,
                               [&](const Scene& one) { return one.draws[0].line_width == width; });
  };
  EXPECT_TRUE(has(simpler_settings(scene), Fixed::from_integer(2)));
  EXPECT_TRUE(has(simpler_settings(scene), Fixed::from_integer(5)));
}

TEST(Settings, TexturesThatNobodyLooksUpGo) {
  Scene scene = plain_scene();
  changes().at("texture")(scene);
  Texture other = *scene.textures[0];
  other.levels[0].texels = {2, 2, 2, 2};
  scene.textures.push_back(std::make_shared<const Texture>(other));
  scene.draws.push_back(scene.draws[0]);
  scene.draws[1].texture->texture = 1;
  for (const Setting& setting : all_settings())
    if (setting.name == std::string("texture")) {
      ASSERT_TRUE(setting.reset(scene, 0));
    }
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0]->levels[0].texels[0], 2);
  EXPECT_EQ(scene.draws[1].texture->texture, 0u);
  EXPECT_TRUE(scene.details.texture);
}

}  // namespace
}  // namespace edgecase
