// SPDX-License-Identifier: MIT
//
// The measurement of multisampled targets measured: what is put wrong must be named, and what was
// measured be told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "profile/profile.h"
#include "profile/samples/samples.h"
#include "tests/profile/sample_renderer.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

TEST(SampleMeasurement, SaysWhereSeveralSamplesAreNotAsOne) {
  const Choices rules{{"triangle.fill-rule", "right-top"}, {"triangle.snap", "8-half-even"}};
  const SurfaceFindings findings =
      findings_of(SampleRenderer(rules).with(RandomScenes::triangles),
                  {{"triangle.fill-rule", "left-bottom"}, {"triangle.snap", "8-half-even"}});
  const Trait& ties = trait_of(findings, "triangle.fill-rule:multisampled");
  EXPECT_EQ(ties.alternative, "right-top");
  EXPECT_EQ(ties.remark, "not as with one sample: left-bottom");
  EXPECT_EQ(ties.rate.agreeing, ties.rate.of);
  const Trait& snap = trait_of(findings, "triangle.snap:multisampled");
  EXPECT_EQ(snap.alternative, "8-half-even");
  EXPECT_EQ(snap.remark, "");
  // The rate of the whole profile is that of the rules that it has.
  const Trait& whole = trait_of(findings, "triangle.coverage:multisampled");
  EXPECT_LT(whole.rate.agreeing, whole.rate.of);
  EXPECT_EQ(findings.choices.at("triangle.fill-rule"), "left-bottom");
}

TEST(SampleMeasurement, FindsLinesThatAreInterpolatedOtherwiseThanWithOneSample) {
  const SurfaceFindings findings = findings_of(SampleRenderer({}).with(RandomScenes::none),
                                               {{"attribute.smooth", "major-axis"}});
  const Trait& trait = trait_of(findings, "attribute.smooth:multisampled");
  EXPECT_EQ(trait.alternative, "projection");
  EXPECT_EQ(trait.rate.agreeing, trait.rate.of);
  EXPECT_EQ(trait.remark, "not as with one sample: major-axis");
  expect_found(findings, "attribute.location", "centre");
}

TEST(SampleMeasurement, FindsPositionsOfEveryNumberOfSamples) {
  const Choices rules{{"triangle.snap", "4-half-even"}};
  const SurfaceFindings findings =
      findings_of(SampleRenderer(rules, {}, {2, 4, 8, 16}).with(RandomScenes::triangles), rules);
  ASSERT_EQ(findings.samples.positions.size(), 4u);
  for (const MeasuredPositions& measured : findings.samples.positions) {
    EXPECT_EQ(measured.placement, "as-reported") << measured.samples;
    ASSERT_EQ(measured.positions.size(), static_cast<std::size_t>(measured.samples));
    for (const MeasuredPosition& one : measured.positions) {
      EXPECT_TRUE(one.is_as_reported());
      EXPECT_LE(one.x.high - one.x.low, Fixed::from_raw(Fixed::kOne / 16));
    }
  }
  EXPECT_EQ(findings.samples.samples, 4);
  expect_found(findings, "sample.positions", "as-reported");
}

TEST(SampleMeasurement, TellsAPlaceThatIsNotReported) {
  // Sample 2 covers what sample 1 covers.
  const auto copying = [](const Scene&, Rendering& rendering) {
    for (Fragment& fragment : rendering.fragments)
      fragment.coverage = (fragment.coverage & ~4u) | (fragment.coverage & 2u) << 1;
    std::erase_if(rendering.fragments,
                  [](const Fragment& fragment) { return fragment.coverage == 0; });
  };
  const SurfaceFindings findings =
      findings_of(SampleRenderer({}, copying).with(RandomScenes::triangles));
  const MeasuredPositions& measured = findings.samples.positions.at(0);
  EXPECT_EQ(measured.placement, "");
  EXPECT_TRUE(measured.positions[1].is_as_reported());
  EXPECT_TRUE(measured.positions[2].is_measured);
  EXPECT_FALSE(measured.positions[2].is_as_reported());
  EXPECT_EQ(trait_of(findings, "sample.positions").remark, "sweeps find nothing catalogued");
  EXPECT_THAT(sample_profile_text(findings.samples), HasSubstr("NOT EQUAL"));
}

TEST(SampleMeasurement, TellsInvocationsAndPlaces) {
  const SurfaceFindings findings = plane_findings_of({{"attribute.centroid", "mean-covered"}});
  ASSERT_EQ(findings.samples.invocations.size(), 13u);
  for (const InvocationRow& row : findings.samples.invocations) {
    SCOPED_TRACE(row.asked + " " + row.location);
    ASSERT_EQ(row.invocations.at(4).size(), 1u);
    EXPECT_EQ(row.invocations.at(4).begin()->first, row.least > 1 ? 4 : 1);
    ASSERT_EQ(row.whole.size(), 1u);
    ASSERT_EQ(row.partial.size(), 1u);
    const bool is_centroid = row.location == "centroid" && row.least == 1;
    EXPECT_EQ(row.partial.begin()->first, row.least > 1 ? "own sample"
                                          : is_centroid ? "mean of the covered samples"
                                                        : "centre");
    // The mean of all samples is the centre.
    EXPECT_EQ(row.whole.begin()->first, row.least > 1 ? "own sample" : "centre");
  }
}

TEST(SampleMeasurement, TellsAttributesThatAreNotAtTheirSamples) {
  for (const InvocationRow& row : opengl_findings().samples.invocations) {
    EXPECT_EQ(row.at_sample, row.asked == "sample" || row.asked == "share 1");
    EXPECT_FALSE(row.is_violation());
  }
  // Centroid attributes stay at the centre, however often the shader runs.
  const SurfaceFindings findings =
      plane_findings_of({}, [](const Scene& scene, Rendering& rendering) {
        if (scene.draws[0].multisampling.location != AttributeLocation::centroid) return;
        for (Fragment& fragment : rendering.fragments) {
          fragment.color[0] = (fragment.x + 0.5) / kPlainSize;
          fragment.color[1] = (fragment.y + 0.5) / kPlainSize;
        }
      });
  for (const InvocationRow& row : findings.samples.invocations)
    EXPECT_EQ(row.is_violation(), row.asked == "share 1" && row.location == "centroid");
  EXPECT_THAT(sample_profile_text(findings.samples), HasSubstr("violation of rulings 29 and 30"));
}

TEST(SampleMeasurement, TellsTheMasksOfAlphas) {
  const SurfaceFindings findings =
      plane_findings_of({{"sample.alpha-to-coverage", "above-quotient"}});
  const auto& runs = findings.samples.alphas;
  ASSERT_EQ(runs.size(), 5u);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].mask, (1u << i) - 1);
    EXPECT_EQ(runs[i].last, static_cast<float>(i) / 4);
  }
}

TEST(SampleMeasurement, TellsSamplesThatAreKeptByTheAlphaOfOthers) {
  const auto other = [](const Scene& scene, Rendering& rendering) {
    if (!scene.draws[0].multisampling.alpha_to_coverage ||
        scene.draws[0].multisampling.location != AttributeLocation::sample)
      return;
    const std::size_t plane = rendering.hits.size() / 4;
    std::rotate(rendering.hits.begin(), rendering.hits.begin() + static_cast<std::ptrdiff_t>(plane),
                rendering.hits.end());
  };
  const Trait& right = trait_of(opengl_findings(), "sample.alpha-to-coverage:own");
  EXPECT_GT(right.rate.of, 500u);
  EXPECT_EQ(right.rate.agreeing, right.rate.of);
  const SurfaceFindings wrong = plane_findings_of({}, other);
  const Trait& trait = trait_of(wrong, "sample.alpha-to-coverage:own");
  EXPECT_LT(trait.rate.agreeing, trait.rate.of);
  EXPECT_EQ(trait.alternative, "not each by its own alpha");
  EXPECT_THAT(trait.remark, HasSubstr("violation of ruling 33"));
  EXPECT_EQ(wrong.choices.at("sample.alpha-to-coverage"), "proportional");
}

TEST(SampleMeasurement, CountsWhatNoAlternativeYields) {
  const SurfaceFindings findings = plane_findings_of({}, [](const Scene&, Rendering& rendering) {
    for (std::uint8_t& value : rendering.pixels) value = static_cast<std::uint8_t>(value ^ 128);
  });
  const Trait& trait = trait_of(findings, "sample.resolve");
  EXPECT_LT(trait.rate.share(), 0.2);
  EXPECT_THAT(trait.remark, HasSubstr("nothing catalogued yields"));
}

TEST(SampleMeasurement, SaysWhyThereIsNothingToMeasure) {
  const SurfaceFindings none = findings_of(SampleRenderer({}, {}, {}));
  EXPECT_EQ(none.samples.unavailable, "not so many");
  EXPECT_EQ(none.samples.counts.size(), 4u);
  EXPECT_TRUE(none.choices.empty());
  EXPECT_TRUE(none.traits.empty());
  EXPECT_EQ(none.drawn.not_drawn, 0u);
  EXPECT_THAT(sample_profile_text(none.samples), HasSubstr("not measured: not so many"));
  EXPECT_EQ(sample_profile_json(none.samples)["unavailable"], "not so many");

  const SurfaceFindings window = findings_of(SampleRenderer({}), {}, Surface::window);
  EXPECT_EQ(window.samples.unavailable, "a window's samples cannot be chosen");
}

TEST(SampleMeasurement, WritesWhatWasMeasured) {
  const SurfaceFindings& findings = opengl_findings();
  const std::string text = sample_profile_text(findings.samples);
  EXPECT_THAT(text, HasSubstr("measured with 4 samples"));
  EXPECT_THAT(text, HasSubstr(" 2 samples: not so many\n"));
  EXPECT_THAT(text, HasSubstr("sample  1: reported (0.875, 0.375), found in x "));
  const auto json = sample_profile_json(findings.samples);
  EXPECT_EQ(json["counts"][0]["made"], false);
  EXPECT_EQ(json["counts"][1]["made"], true);
  EXPECT_EQ(json["positions"][0]["placement"], "as-reported");
  EXPECT_EQ(json["positions"][0]["positions"][3]["equal"], true);
  EXPECT_EQ(json["invocations"].size(), 13u);
  EXPECT_EQ(json["alpha_to_coverage"].size(), 5u);
}

}  // namespace
}  // namespace edgecase
