// SPDX-License-Identifier: MIT
//
// What fragments look up exactly is the same whether exact has drawn it or not, and is looked up in
// the chain that the renderer tells.
#include "diff/textures/texture_lookups.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "raster/rasterizer.h"
#include "tests/diff/textures/texture_judging.h"

namespace edgecase {
namespace {

// Of all fragments of a rendering, bit for bit, the levels first.
std::vector<std::uint64_t> looked_up(const Scene& scene, const Rendering& exact,
                                     const Rendering& rendered) {
  const auto primitives = primitives_of(scene);
  const RuleChoices choices = resolve({}, scene.target.surface);
  const ValueContext context(scene, primitives, choices, 8, Latitude::opengl);
  ExactLookups lookups(context, exact, rendered);
  std::vector<std::uint64_t> numbers;
  for (const Fragment& f : rendered.fragments) {
    const LookedUp lookup = lookups.look_up(f);
    for (const double number : lookup.level_of_detail)
      numbers.push_back(std::bit_cast<std::uint64_t>(number));
    for (const double number : lookup.color)
      numbers.push_back(std::bit_cast<std::uint64_t>(number));
  }
  return numbers;
}

Rendering without_details(Rendering rendering) {
  rendering.details.clear();
  for (Fragment& f : rendering.fragments) f.detail = -1;
  return rendering;
}

TEST(ExactLookups, AreTheSameWhetherDrawnOrNot) {
  for (const TexturedScene& textured : judged_textures()) {
    SCOPED_TRACE(textured.name);
    Scene scene = textured.scene;
    scene.details.texture = true;
    const Rendering exact = rasterize(scene, {});
    ASSERT_FALSE(exact.fragments.empty());
    const auto of_drawn = looked_up(scene, exact, exact);
    EXPECT_EQ(of_drawn, looked_up(scene, {}, exact));
    Rendering half = exact;
    half.fragments.resize(half.fragments.size() / 2);
    EXPECT_EQ(of_drawn, looked_up(scene, half, exact));
  }
}

// Only what a renderer tells is asked for.
TEST(ExactLookups, OfRenderersThatTellNoLevelAreColours) {
  const Scene& scene = textures_named("floor");
  const Rendering exact = rasterize(scene, {});
  const Rendering unreported = without_details(exact);
  const auto of_drawn = looked_up(scene, unreported, unreported);
  EXPECT_EQ(of_drawn, looked_up(scene, {}, unreported));
  EXPECT_EQ(of_drawn, looked_up(scene, exact, unreported));
  ASSERT_EQ(of_drawn.size(), 6 * unreported.fragments.size());
  for (std::size_t i = 0; i < unreported.fragments.size(); ++i) {
    EXPECT_EQ(of_drawn[6 * i], 0u);
    EXPECT_EQ(of_drawn[6 * i + 1], 0u);
    for (std::size_t c = 0; c < 4; ++c)
      ASSERT_EQ(of_drawn[6 * i + 2 + c], std::bit_cast<std::uint64_t>(exact.fragments[i].color[c]));
  }
}

TEST(ExactLookups, LookIntoTheChainThatTheRendererTells) {
  const Scene& scene = textures_named("generated codes");
  const Rendering exact = rasterize(scene, {});
  Rendering other = exact;
  for (TextureLevel& level : other.mip_chains.at(0))
    for (float& texel : level.texels) texel = 255 - texel;
  const auto in_other = looked_up(scene, exact, other);
  EXPECT_NE(in_other, looked_up(scene, exact, exact));
  EXPECT_EQ(in_other, looked_up(scene, {}, other));
  // Chains of other sizes than the scene's are nothing to look up exactly in.
  Rendering shorter = exact;
  shorter.mip_chains.at(0).pop_back();
  EXPECT_EQ(looked_up(scene, exact, shorter), looked_up(scene, exact, exact));
}

// A lambda' that is not permitted says nothing of the level: what is permitted is told with it, and
// holds what exact has. This is so with explicit levels, too, where lambda' is that of the query.
TEST(TextureLookups, LevelsThatArePermittedHoldExactsOwnWhateverIsReported) {
  Sampler sampler;
  sampler.mipmap = MipFilter::linear;
  Lookup explicit_level;
  explicit_level.kind = LookupKind::lod;
  explicit_level.value = 2;
  std::vector<Scene> scenes{flat_scene(1.25, TextureFormat::rgba8, sampler, explicit_level)};
  for (const TexturedScene& textured : judged_textures()) scenes.push_back(textured.scene);
  int beyond = 0;
  for (Scene& scene : scenes) {
    scene.details.texture = true;
    const Rendering exact = rasterize(scene, {});
    const Rendering rendered = changed_textures(scene, level_moved(3));
    const auto primitives = primitives_of(scene);
    const RuleChoices choices = resolve({}, scene.target.surface);
    const ValueContext context(scene, primitives, choices, 8, Latitude::opengl);
    TextureLookups lookups(context, exact, rendered);
    for (const Fragment& f : rendered.fragments) {
      const FragmentDetail* detail = lookups.detail_of(f);
      if (detail == nullptr || !detail->level_of_detail) continue;
      const Boxes permitted = lookups.permitted_levels(f, TextureLookups::Reach::all);
      if (permitted.front()[1].contains((*detail->level_of_detail)[1])) continue;
      ++beyond;
      const auto own = lookups.exact(f).level_of_detail;
      EXPECT_TRUE(hold(permitted, {own[0], own[1]})) << describe_range(permitted);
    }
  }
  EXPECT_GT(beyond, 500);
}

}  // namespace
}  // namespace edgecase
