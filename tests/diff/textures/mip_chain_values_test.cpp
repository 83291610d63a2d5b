// SPDX-License-Identifier: MIT
//
// Mip chains that a renderer made (rulings 25 and 48): their number and sizes may be wrong, and
// texels that no filter makes of the level above.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "raster/rasterizer.h"
#include "rules/textures/mip_chain.h"
#include "tests/diff/textures/texture_judging.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

using Causes = std::set<std::string>;
using Chain = std::vector<TextureLevel>;

// The rest of the answer follows the chain that is told.
Result with_chain(const Scene& scene, const std::function<void(Chain&)>& change) {
  Rendering rendered = rasterize(scene, {});
  change(rendered.mip_chains.at(0));
  return judge_textures(scene, rendered);
}

void expect_wrong_sizes(const Result& result, const std::string& cause) {
  EXPECT_EQ(result.verdict, Verdict::violation) << describe_textures(result);
  const auto of_sizes = std::ranges::count_if(result.disagreements, [&](const Disagreement& d) {
    return d.rule == "mipmap.level-count" && !is_legal(d) && d.cause == cause;
  });
  EXPECT_EQ(of_sizes, 1) << describe_textures(result);
}

TEST(MipChainValues, WrongNumbersAndSizesAreFaults) {
  const Scene& scene = textures_named("generated codes");  // 13x6, 6x3, 3x1, 1x1
  expect_wrong_sizes(with_chain(scene, [](Chain& chain) { chain.pop_back(); }),
                     "mipmap.level-count=smaller-side");
  expect_wrong_sizes(with_chain(scene, [](Chain& chain) { chain.resize(1); }), "");
  expect_wrong_sizes(with_chain(scene, [](Chain& chain) { chain.clear(); }), "");
  expect_wrong_sizes(with_chain(scene, [](Chain& chain) { chain.push_back(chain.back()); }), "");
  expect_wrong_sizes(with_chain(scene,
                                [](Chain& chain) {
                                  chain[1] = {7, 3, std::vector<float>(84, 0)};
                                }),
                     "");
}

// Every texel of the wrong chain that is looked up is the renderer's own: told once, by the chain.
TEST(MipChainValues, LookupsInAShortChainAreNotReportedAgain) {
  for (const char* name : {"generated codes", "generated even codes"}) {
    const Scene& scene = textures_named(name);
    const Rendering rendered = rasterize(scene, policy_from({"mipmap.level-count=smaller-side"}));
    const Result result = judge_textures(scene, rendered);
    ASSERT_EQ(result.disagreements.size(), 1u) << describe_textures(result);
    expect_wrong_sizes(result, "mipmap.level-count=smaller-side");
  }
}

TEST(MipChainValues, WhatWasGivenStays) {
  const Scene& scene = textures_named("generated codes");
  const Result result = with_chain(scene, [](Chain& chain) { chain[0].texels[9] = 3; });
  EXPECT_EQ(result.verdict, Verdict::violation) << describe_textures(result);
  ASSERT_EQ(result.disagreements.size(), 1u);
  EXPECT_EQ(result.disagreements[0].rule, "mipmap.filter");
}

TEST(MipChainValues, OtherTexelsArePermitted) {
  for (const TextureFormat format :
       {TextureFormat::rgba8, TextureFormat::rgba32f, TextureFormat::srgb8}) {
    const Scene scene = generated_scene(13, 7, format);
    SCOPED_TRACE(name_of(format));
    const Rendering exact = rasterize(scene, {});
    Rendering other = exact;
    other.mip_chains.at(0)[1].texels[5] += 1;
    // Colours that fit what is told.
    Scene reported = scene;
    Texture texture = *scene.textures[0];
    texture.generated = false;
    texture.levels = other.mip_chains.at(0);
    reported.textures = {std::make_shared<const Texture>(texture)};
    const Rendering fitting = rasterize(reported, {});
    other.fragments = fitting.fragments;
    other.pixels = fitting.pixels;
    const Result result = judge_textures(scene, other);
    EXPECT_EQ(result.verdict, Verdict::permitted) << describe_textures(result);
    ASSERT_EQ(result.values.size(), 1u) << describe_textures(result);
    EXPECT_EQ(result.values[0].differing.size(), 1u);
    EXPECT_EQ(result.values[0].worst_ulp, 1);
    // A texel may lie outside of the target.
    EXPECT_EQ(result.values[0].worst.x, 0);
    EXPECT_EQ(result.values[0].rule, "mipmap.filter");
    // Colours of exact's own chain do not.
    Rendering stale = exact;
    stale.mip_chains = other.mip_chains;
    stale.mip_chains.at(0)[1].texels[4] +=
        scene.textures[0]->format == TextureFormat::rgba32f
            ? 90.f
            : -std::min(90.f, stale.mip_chains.at(0)[1].texels[4]);
    EXPECT_EQ(judge_textures(scene, stale).verdict, Verdict::violation);
  }
}

// A generated level of this texture that is told as another one.
std::set<int> rulings_with_level(TextureFormat format, const std::array<float, 4>& image,
                                 std::size_t which, const std::array<float, 4>& level) {
  Scene scene = generated_scene(8, 8, format);
  Texture texture = *scene.textures[0];
  for (std::size_t i = 0; i < texture.levels[0].texels.size(); ++i)
    texture.levels[0].texels[i] = image[i % 4];
  scene.textures = {std::make_shared<const Texture>(texture)};
  Rendering rendered = rasterize(scene, {});
  Chain& chain = rendered.mip_chains.at(0);
  for (std::size_t i = 0; i < chain[which].texels.size(); ++i)
    chain[which].texels[i] = level[i % 4];
  std::set<int> rulings;
  for (const Disagreement& d : judge_textures(scene, rendered).disagreements)
    if (!is_legal(d) && d.rule == "mipmap.filter") rulings.insert(d.ruling);
  return rulings;
}

// Whatever the filter, an image of one colour keeps it, but for rounding once.
TEST(MipChainValues, AnImageOfOneColourStaysSo) {
  for (const TextureFormat format : {TextureFormat::rgba8, TextureFormat::srgb8}) {
    const std::array<float, 4> white{255, 255, 255, 255};
    EXPECT_EQ(rulings_with_level(format, white, 1, {0, 0, 0, 0}), std::set<int>{25});
    EXPECT_EQ(rulings_with_level(format, white, 3, {255, 253, 255, 255}), std::set<int>{25});
    EXPECT_EQ(rulings_with_level(format, white, 2, {254, 255, 254, 255}), std::set<int>{});
  }
  const std::array<float, 4> some{0.5F, -3, 1e6F, 0};
  EXPECT_EQ(rulings_with_level(TextureFormat::rgba32f, some, 1, {0.5F, -3, 1e6F + 2, 0}),
            std::set<int>{});
  EXPECT_EQ(rulings_with_level(TextureFormat::rgba32f, some, 1, {0.5F, -3.001F, 1e6F, 0}),
            std::set<int>{25});
}

// An image of 16x16 that is black on the left and white on the right, and what is told of the
// levels that are made of it: the rulings that it breaks.
std::set<int> rulings_of_halves(const std::function<void(Chain&)>& change) {
  Scene scene = generated_scene(16, 16, TextureFormat::rgba8);
  Texture texture = *scene.textures[0];
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 16; ++i)
      for (std::size_t c = 0; c < 4; ++c)
        texture.levels[0].texels[texture.levels[0].index(i, j) + c] = i < 8 ? 50 : 200;
  scene.textures = {std::make_shared<const Texture>(texture)};
  std::set<int> rulings;
  for (const Disagreement& d : with_chain(scene, change).disagreements)
    if (!is_legal(d) && d.rule == "mipmap.filter") rulings.insert(d.ruling);
  return rulings;
}

// Levels of extreme renderers.
TEST(MipChainValues, LevelsThatAreNoReductionsAreViolations) {
  EXPECT_EQ(rulings_of_halves([](Chain&) {}), std::set<int>{});
  EXPECT_EQ(rulings_of_halves([](Chain& chain) { std::ranges::reverse(chain[1].texels); }),
            std::set<int>{25});
  for (const float constant : {0.F, 50.F, 200.F, 255.F})
    EXPECT_EQ(
        rulings_of_halves([&](Chain& chain) { std::ranges::fill(chain[1].texels, constant); }),
        std::set<int>{25})
        << constant;
  EXPECT_EQ(rulings_of_halves([](Chain& chain) {
              for (std::size_t i = 0; i < chain[1].texels.size(); ++i)
                chain[1].texels[i] = static_cast<float>(i * 97 % 256);
            }),
            std::set<int>{25});
}

// Of 8x8 texels in level 1, those of column i are made of columns 2i and 2i + 1. A difference of
// 150 codes is 16 columns wide.
TEST(MipChainValues, TexelsHaveToDoWithThoseNearThem) {
  const auto rulings_by = [](int column, float code) {
    return rulings_of_halves([&](Chain& chain) {
      for (std::size_t c = 0; c < 4; ++c) chain[1].texels[chain[1].index(column, 3) + c] = code;
    });
  };
  // Columns 4 to 9 are the window of column 3, and 5 to 9 that of the tests.
  EXPECT_EQ(rulings_by(3, 200), std::set<int>{});
  EXPECT_EQ(rulings_by(3, 201), std::set<int>{});
  EXPECT_EQ(rulings_by(3, 202), std::set<int>{48});
  EXPECT_EQ(rulings_by(3, 49), std::set<int>{});
  EXPECT_EQ(rulings_by(3, 0), std::set<int>{48});
  // Columns 6 to 11 are the window of column 4, and 7 to 11 that of the tests: one black column.
  EXPECT_EQ(rulings_by(4, 50), std::set<int>{});
  // Columns 8 to 13 are the window of column 5.
  EXPECT_EQ(rulings_by(5, 199), std::set<int>{});
  EXPECT_EQ(rulings_by(5, 198), std::set<int>{25});
  EXPECT_EQ(rulings_by(2, 51), std::set<int>{});
  EXPECT_EQ(rulings_by(2, 52), std::set<int>{25});
}

// Whatever the size, a mean of texels near a texel's own is permitted.
TEST(MipChainValues, CataloguedFiltersOfAnySizeArePermitted) {
  for (const auto& [width, height] :
       {std::pair(13, 7), std::pair(16, 1), std::pair(3, 5), std::pair(31, 2), std::pair(9, 9)})
    for (const MipmapFilter filter : values_of<MipmapFilter>()) {
      const Scene scene = generated_scene(width, height, TextureFormat::rgba8);
      const Result result =
          judge_follower(scene, {std::string("mipmap.filter=") + name_of(filter)});
      EXPECT_LE(result.verdict, Verdict::convention) << describe_textures(result);
    }
}

TEST(MipChainValues, AllPairsOfFilterAndRoundingAreNamed) {
  const Scene& scene = textures_named("generated codes");
  int named = 0;
  for (const MipmapFilter filter : values_of<MipmapFilter>())
    for (const MipmapRounding rounding : values_of<MipmapRounding>()) {
      const std::string of_filter = std::string("mipmap.filter=") + name_of(filter);
      const std::string of_rounding = std::string("mipmap.rounding=") + name_of(rounding);
      const Result result = judge_follower(scene, {of_filter, of_rounding});
      if (result.verdict == Verdict::agree) continue;
      ++named;
      EXPECT_EQ(result.verdict, Verdict::convention) << describe_textures(result);
      ASSERT_EQ(causes_of(result).size(), 1u);
      // Of nearest texels every rounding is the same.
      const std::string cause = *causes_of(result).begin();
      if (filter != MipmapFilter::box) {
        EXPECT_NE(cause.find(of_filter), std::string::npos) << cause;
      }
      if (rounding != MipmapRounding::nearest_even && filter != MipmapFilter::nearest) {
        EXPECT_NE(cause.find(of_rounding), std::string::npos) << cause;
      }
    }
  EXPECT_EQ(named, 11);
}

// As few parts as possible, seen from the policy: of even sizes box and bilinear are one.
TEST(MipChainValues, TheNearestWayToThePolicyIsNamed) {
  const Scene& scene = textures_named("generated even codes");
  const Policy policy = policy_from({"mipmap.filter=bilinear-centre", "mipmap.rounding=half-up"});
  const Result result =
      judge_textures(scene, rasterize(scene, policy_from({"mipmap.rounding=down"})), policy);
  EXPECT_EQ(causes_of(result), Causes{"mipmap.rounding=down"}) << describe_textures(result);
}

TEST(MipChainValues, NumbersThatAreNoneAreTheSameAsThemselves) {
  Scene scene = textures_named("generated floats");
  Texture texture = *scene.textures[0];
  texture.levels[0].texels[2] = std::nanf("");
  texture.levels[0].texels[7] = HUGE_VALF;
  scene.textures = {std::make_shared<const Texture>(texture)};
  EXPECT_EQ(judge_textures(scene, rasterize(scene, {})).verdict, Verdict::agree);
}

}  // namespace
}  // namespace edgecase
