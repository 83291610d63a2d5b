// SPDX-License-Identifier: MIT
//
// The measurement of multisampled targets measured: the exact rasterizer under a policy, reporting
// the standard positions whatever it does, must be found to follow it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/profile/planted_rounds.h"
#include "tests/profile/sample_renderer.h"

namespace edgecase {
namespace {

const Choices kOpenGl{{"sample.positions", "as-reported"},
                      {"line.multisampled", "rectangle"},
                      {"sample.enable", "honoured"},
                      {"sample.mask", "applied"},
                      {"sample.shading-rate", "as-needed"},
                      {"attribute.location", "centre"},
                      {"attribute.centroid", "centre-or-first"},
                      {"sample.depth", "at-sample"},
                      {"sample.alpha-to-coverage", "proportional"},
                      {"sample.resolve", "nearest-even"}};

// Those that hide nothing of each other; the last two hide others.
const std::vector<PlantedRound> kRounds{
    {{{"line.multisampled", "snapped-offset"},
      {"sample.enable", "depth-of-first"},
      {"attribute.location", "first-covered"},
      {"attribute.centroid", "first-covered"},
      {"sample.depth", "centre"},
      {"sample.alpha-to-coverage", "above-quotient"},
      {"sample.resolve", "half-up"}},
     {}},
    {{{"line.multisampled", "snapped-offset-across-borders"},
      {"sample.enable", "ignored"},
      {"attribute.location", "half-pixel-off"},
      {"attribute.centroid", "mean-covered"},
      {"sample.depth", "mirrored-x"},
      {"sample.alpha-to-coverage", "above-quotient-of-others"},
      {"sample.resolve", "truncated"}},
     {}},
    {{{"line.multisampled", "snapped-corners"},
      {"sample.enable", "ignored-but-for-lines"},
      {"sample.shading-rate", "per-pixel"},
      {"attribute.centroid", "centre"},
      {"sample.depth", "mirrored-x-or-zero"},
      {"sample.alpha-to-coverage", "spread"},
      {"sample.resolve", "half-up-by-pairs"}},
     {}},
    {{{"line.multisampled", "parallelogram"},
      {"sample.enable", "ignored-but-whole-lines"},
      {"sample.depth", "half-pixel-off"},
      {"sample.alpha-to-coverage", "ignored"},
      {"sample.resolve", "float32-sum"}},
     {}},
    {{{"line.multisampled", "single-sampled"}, {"sample.resolve", "first-sample"}}, {}},
    // Without the mask all samples of a pixel are alike, and nothing tells how they are resolved.
    {{{"sample.mask", "ignored"}}, {"sample.resolve"}},
    // Where the shader always runs for each sample, there is one place for attributes, and the
    // invocations of masked pixels are none that a mask's alternatives have.
    {{{"sample.shading-rate", "per-sample"}},
     {"sample.mask", "attribute.location", "attribute.centroid"}}};

// The round's own rules and OpenGL's are found, all of them; but for those that it hides.
void expect_all_found(const SurfaceFindings& findings, const PlantedRound& round) {
  for (const auto& [rule, alternative] : rules_to_find(round, kOpenGl))
    expect_found(findings, rule, alternative);
  EXPECT_EQ(findings.drawn.not_drawn, 0u) << findings.drawn.first_failure;
  for (const char* id : {"triangle.coverage:multisampled", "line.coverage:multisampled",
                         "line.coverage:multisampled-wide", "line.multisampled:boundary"}) {
    const Trait& trait = trait_of(findings, id);
    EXPECT_GE(trait.rate.of, 100u) << id;
    EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << id;
  }
}

TEST(SampleMeasurement, FindsOpenGlsOwnRules) {
  expect_all_found(opengl_findings(), {});
}

TEST(SampleMeasurement, FindsEveryAlternative) {
  for (std::size_t i = 0; i < kRounds.size(); ++i) {
    if (!is_in_share_of_few(i, kRounds.size())) continue;
    SCOPED_TRACE(i);
    expect_all_found(findings_of(SampleRenderer(kRounds[i].rules)), kRounds[i]);
  }
}

// Placements have a test of their own.
TEST(SampleMeasurement, EveryAlternativeIsPlanted) {
  Choices standard = kOpenGl;
  standard.erase("sample.positions");
  std::vector<PlantedRound> rounds = kRounds;
  rounds.push_back({});
  expect_each_planted(rounds, standard);
}

TEST(SampleMeasurement, FindsEveryPlacement) {
  const std::vector<std::string> names{"ordered-grid", "centre", "mirrored-x",
                                       "mirrored-y",   "turned", "swapped"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!is_in_share_of_few(i, names.size())) continue;
    SCOPED_TRACE(names[i]);
    const SurfaceFindings findings =
        findings_of(SampleRenderer({{"sample.positions", names[i]}}).with(RandomScenes::triangles));
    expect_found(findings, "sample.positions", names[i]);
    ASSERT_EQ(findings.samples.positions.size(), 1u);
    EXPECT_EQ(findings.samples.positions[0].placement, names[i]);
    EXPECT_TRUE(std::any_of(
        findings.samples.positions[0].positions.begin(),
        findings.samples.positions[0].positions.end(),
        [](const MeasuredPosition& one) { return one.is_measured && !one.is_as_reported(); }));
    // With all samples in one place no mask is partial: nothing tells centroids apart.
    if (names[i] != "centre") expect_found(findings, "attribute.centroid", "centre-or-first");
    const Trait& triangles = trait_of(findings, "triangle.coverage:multisampled");
    EXPECT_EQ(triangles.rate.agreeing, triangles.rate.of);
  }
}

}  // namespace
}  // namespace edgecase
