// SPDX-License-Identifier: MIT
//
// The measurement of textures measured: the exact rasterizer under a policy must be found to follow
// it.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "tests/profile/planted_rounds.h"
#include "tests/profile/texture_findings.h"

namespace edgecase {
namespace {

const Choices kOpenGl{{"texture.wrap", "as-set"},
                      {"texture.texel-grid", "none"},
                      {"texture.scale-factor", "lengths"},
                      {"texture.log2", "exact"},
                      {"texture.derivatives", "quad-fine"},
                      {"texture.lod-bias", "as-set"},
                      {"texture.crossover", "zero"},
                      {"texture.nearest-level", "down-at-ties"},
                      {"texture.level-weight", "exact"},
                      {"texture.anisotropy", "extension"},
                      {"mipmap.filter", "box"},
                      {"mipmap.rounding", "nearest-even"},
                      {"mipmap.srgb", "linear"}};

// Those that hide nothing of each other: one vector alone does not tell in which row or column the
// other was taken, and half a level more leaves no footprint halfway between levels but where it is
// planted. Each filter of chains has each rounding, both with each meaning of sRGB.
const std::vector<PlantedRound> kRounds{
    {{{"texture.scale-factor", "x-only"},
      {"texture.log2", "linear-mantissa"},
      {"texture.derivatives", "analytic"},
      {"texture.level-weight", "floor-8"},
      {"texture.texel-grid", "floor-8"},
      {"texture.nearest-level", "up-at-ties"},
      {"texture.crossover", "by-filters"},
      {"texture.lod-bias", "sampler-nearest-8"},
      {"texture.anisotropy", "gaussian-5"},
      {"texture.wrap", "mirrored-as-repeat"},
      {"mipmap.rounding", "half-up"}},
     {}},
    {{{"texture.scale-factor", "y-only"},
      {"texture.log2", "linear-mantissa-of-square"},
      {"texture.derivatives", "forward"},
      {"texture.level-weight", "nearest-8"},
      {"texture.texel-grid", "nearest-8"},
      {"texture.nearest-level", "even-at-ties"},
      {"texture.lod-bias", "unclamped"},
      {"texture.anisotropy", "none"},
      {"mipmap.rounding", "down"}},
     {}},
    {{{"texture.scale-factor", "length-of-sum"},
      {"texture.log2", "linear-mantissa-of-fourth-power"},
      {"texture.derivatives", "quad-fine-odd"},
      {"texture.level-weight", "floor-4"},
      {"texture.texel-grid", "linear-even-8"},
      {"texture.lod-bias", "not-of-gradients"},
      {"mipmap.rounding", "half-up-by-rows"}},
     {}},
    {{{"texture.scale-factor", "largest-partial"},
      {"texture.log2", "mantissa-8"},
      {"texture.derivatives", "quad-coarse-top-left"},
      {"texture.level-weight", "nearest-4"},
      {"mipmap.rounding", "half-up"},
      {"mipmap.srgb", "codes"}},
     {}},
    {{{"texture.scale-factor", "sum-of-partials"},
      {"texture.log2", "linear-mantissa"},
      {"texture.derivatives", "quad-coarse-bottom-right"},
      {"texture.level-weight", "floor-3"},
      {"mipmap.filter", "bilinear-centre"}},
     {}},
    {{{"texture.scale-factor", "length-of-both"},
      {"texture.derivatives", "quad-coarse-bottom-left"},
      {"texture.level-weight", "nearest-3"},
      {"mipmap.filter", "bilinear-centre"},
      {"mipmap.rounding", "half-up"}},
     {}},
    {{{"texture.scale-factor", "sum"},
      {"texture.derivatives", "quad-coarse-top-right"},
      {"texture.level-weight", "narrow"},
      {"mipmap.filter", "bilinear-centre"},
      {"mipmap.rounding", "down"}},
     {}},
    {{{"texture.derivatives", "quad-other-row"},
      {"texture.level-weight", "one-at-ties"},
      {"mipmap.filter", "bilinear-centre"},
      {"mipmap.rounding", "half-up-by-rows"}},
     {}},
    {{{"texture.lod-bias", "half-a-level-more"},
      {"mipmap.filter", "bilinear-centre"},
      {"mipmap.rounding", "half-up"},
      {"mipmap.srgb", "codes"}},
     {}},
    // A single texel is rounded in no way, and its mean is the same in codes.
    {{{"mipmap.filter", "nearest"}, {"texture.level-weight", "whole"}},
     {"mipmap.rounding", "mipmap.srgb"}},
    {{{"mipmap.filter", "nearest"}, {"mipmap.srgb", "codes"}}, {"mipmap.rounding", "mipmap.srgb"}}};

// The round's own rules and OpenGL's are found, all of them; but for those that it hides.
void expect_all_found(const PlantedRound& round, Surface surface = Surface::fbo) {
  const SurfaceFindings findings = findings_of(round.rules, surface);
  const Choices expected = rules_to_find(round, kOpenGl);
  for (const auto& [rule, alternative] : expected) expect_found(findings, rule, alternative);
  EXPECT_EQ(findings.choices, expected);
  for (const char* id : {"mipmap.filter", "mipmap.filter:srgb8", "mipmap.filter:rgba32f"}) {
    const Trait& trait = trait_of(findings, id);
    EXPECT_EQ(trait.alternative, expected.at("mipmap.filter")) << id;
    EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << id;
    EXPECT_GT(trait.rate.of, 100u) << id;
  }
}

TEST(TextureMeasurement, FindsOpenGlsOwnRules) {
  for (const Surface surface : {Surface::fbo, Surface::window}) expect_all_found({}, surface);
}

TEST(TextureMeasurement, FindsEveryAlternative) {
  for (std::size_t i = 0; i < kRounds.size(); ++i) {
    if (!is_in_share_of_few(i, kRounds.size())) continue;
    SCOPED_TRACE(i);
    expect_all_found(kRounds[i]);
  }
}

TEST(TextureMeasurement, EveryAlternativeIsPlanted) {
  std::vector<PlantedRound> rounds = kRounds;
  rounds.push_back({});
  expect_each_planted(rounds, kOpenGl);
}

TEST(TextureMeasurement, FindsTheSameOfWindows) {
  const std::vector<Choices> planted{{{"texture.scale-factor", "largest-partial"},
                                      {"texture.log2", "mantissa-8"},
                                      {"texture.derivatives", "quad-coarse-top-left"}},
                                     {{"texture.scale-factor", "sum-of-partials"},
                                      {"texture.log2", "linear-mantissa"},
                                      {"texture.derivatives", "quad-coarse-bottom-right"}}};
  for (std::size_t i = 0; i < planted.size(); ++i)
    if (is_in_share_of_few(i, planted.size())) expect_all_found({planted[i], {}}, Surface::window);
}

}  // namespace
}  // namespace edgecase
