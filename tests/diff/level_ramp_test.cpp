// SPDX-License-Identifier: MIT
//
// Ramps of levels of detail along a strip, and the band that is permitted.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>

#include "diff/compare.h"
#include "diff/display_data.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "tests/diff/textures/texture_judging.h"
#include "tests/raster/texture_scenes.h"

namespace edgecase {
namespace {

TEST(LevelRamp, TheRampIsWhatFragmentsOfAStripTell) {
  const Placement place{{0, 0}, {32, 2}, {0, 0}, {1.5f, 0.0625f}};
  Scene strip = textured_scene(32, 2, *textures_named("floor").textures[0], place,
                               sampler_of(Filter::linear, MipFilter::linear));
  for (const std::size_t right : {1u, 3u}) strip.draws[0].vertices[right].w = 8;
  const auto ramp = level_ramp(strip, {}, changed_textures(strip, level_moved(0.01)), {8});
  ASSERT_EQ(ramp.size(), 32u);
  const Rendering exact = rasterize(strip, {});
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    const Result::LevelPoint& point = ramp[i];
    EXPECT_EQ(point.x, static_cast<int>(i));
    EXPECT_EQ(point.y, 0);
    const Fragment& f = exact.fragments[i];
    EXPECT_EQ(point.exact,
              exact.details[static_cast<std::size_t>(f.detail)].level_of_detail.value()[1]);
    EXPECT_NEAR(point.rendered, point.exact + 0.01, 1e-9);
    EXPECT_LT(point.low, point.exact);
    EXPECT_GT(point.high, point.exact);
    EXPECT_LT(point.high - point.low, 3);
  }
}

// The band of an axis-aligned footprint, worked out by hand: from log2 of max(m_u, m_v) to that of
// the larger bound, and a 64th of a level more.
TEST(LevelRamp, TheBandIsThatOfTheLeastAndTheMost) {
  const Texture texture = chain_of(64, 64, TextureFormat::rgba32f, distinct);
  for (const double u : {1.5, 3.0, 5.25})
    for (const double v : {0.25, 2.0}) {
      const Placement place{
          {0, 0}, {32, 2}, {0, 0}, {static_cast<float>(u / 2), static_cast<float>(v / 32)}};
      const Scene strip =
          textured_scene(32, 2, texture, place, sampler_of(Filter::linear, MipFilter::linear));
      const auto ramp = level_ramp(strip, {}, rasterize(strip, {}), {8});
      EXPECT_EQ(ramp.size(), 32u);
      for (const auto& point : ramp) {
        EXPECT_NEAR(point.low, std::log2(std::max(u, v)), 0.08);
        const double most = std::max(u + v, std::sqrt(2.0) * std::max(u, v));
        EXPECT_NEAR(point.high, std::log2(most), 0.12);
        EXPECT_LE(point.low, std::log2(std::max(u, v)));
        EXPECT_GE(point.high, std::log2(most));
      }
    }
}

// What a renderer says of itself bounds its levels: its limit of biases, and its API.
TEST(LevelLimits, AreTheRenderersOwn) {
  const auto facts = [](std::map<std::string, std::string> traits) {
    RendererInfo info;
    info.traits = std::move(traits);
    return facts_of(info, nullptr);
  };
  EXPECT_EQ(facts({}).lookups, LookupLimits{});
  EXPECT_EQ(facts({{"max_texture_lod_bias", "15"}}).lookups, (LookupLimits{15, false}));
  for (const char* nothing : {"1", "-3", "inf", "many", ""})
    EXPECT_EQ(facts({{"max_texture_lod_bias", nothing}}).lookups, LookupLimits{}) << nothing;
  EXPECT_EQ(facts({{"api", "OpenGL ES"}}).lookups, (LookupLimits{2, true}));
  EXPECT_EQ(facts({{"api", "OpenGL"}}).lookups, LookupLimits{});
  // The sampler's bias is 10: it may be clamped at 5 where nothing is told.
  const Scene& scene = textures_named("far bias");
  const Rendering clamped = changed_textures(scene, [](Fragment& f, FragmentDetail& detail) {
    f.has_color = false;
    detail.level_of_detail.value()[1] -= 5;
  });
  const auto verdict = [&](const RendererFacts& known) {
    Result result = compare(scene, {}, rasterize(scene, {}), clamped, known);
    Result* const alone[] = {&result};
    judge(alone, Latitude::opengl);
    return result.verdict;
  };
  EXPECT_LE(verdict(facts({})), Verdict::permitted);
  EXPECT_EQ(verdict(facts({{"max_texture_lod_bias", "16"}})), Verdict::violation);
}

}  // namespace
}  // namespace edgecase
