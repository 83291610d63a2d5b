// SPDX-License-Identifier: MIT
//
// The measurement of multisampled targets measured: the exact rasterizer under a policy, reporting
// the standard positions whatever it does, must be found to follow it, and what is put wrong must
// be named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "profile/samples/sample_json.h"
#include "profile/samples/sample_measurement.h"
#include "profile/samples/sample_scenes.h"
#include "profile/samples/sample_text.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

using Alter = std::function<void(const Scene&, Rendering&)>;

// Makes some numbers of samples, has the standard positions reported, and puts something wrong.
class SampleRenderer final : public Renderer {
 public:
  explicit SampleRenderer(Choices rules, Alter alter = {}, std::vector<int> made = {4})
      : alter_(std::move(alter)), made_(std::move(made)) {
    policy_.rules = std::move(rules);
  }
  const RendererInfo& info() const override {
    static const RendererInfo info{"samples", "", "", "samples", 8, {}};
    return info;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const Scene& scene = *tasks[i].scene;
      EXPECT_FALSE(tasks[i].coverage_only);
      EXPECT_EQ(scene.target.surface, Surface::fbo);
      const int samples = scene.target.samples;
      if (std::find(made_.begin(), made_.end(), samples) == made_.end()) {
        sink(i, Failure{FailureKind::unsupported, "not so many"});
        continue;
      }
      Rendering rendering = rasterize(scene, policy_, standard_pattern(samples));
      rendering.sample_positions = standard_pattern(samples);
      if (alter_) alter_(scene, rendering);
      sink(i, std::move(rendering));
    }
  }

 private:
  Policy policy_;
  Alter alter_;
  std::vector<int> made_;
};

SampleFindings findings_of(SampleRenderer renderer, const Choices& found = {},
                           Surface surface = Surface::fbo) {
  SampleMeasureQuestion question;
  question.surface = surface;
  question.scenes_per_kind = 100;
  question.found = found;
  std::size_t told = 0;
  SampleFindings findings = measure_samples(
      renderer, question, [&](std::size_t more) { told += more; }, nullptr);
  EXPECT_EQ(told, sample_scene_count(question.scenes_per_kind));
  return findings;
}

SampleFindings findings_under(const Choices& rules) {
  return findings_of(SampleRenderer(rules));
}

const Trait& trait_of(const SampleFindings& findings, const std::string& id) {
  for (const Trait& trait : findings.traits)
    if (trait.id == id) return trait;
  ADD_FAILURE() << "no trait " << id;
  static const Trait none;
  return none;
}

// Found, agreed with by all that tells, and by nothing as well as by it.
void expect_found(const SampleFindings& findings, const std::string& id,
                  const std::string& alternative) {
  const Trait& trait = trait_of(findings, id);
  EXPECT_EQ(trait.alternative, alternative) << id;
  EXPECT_GT(trait.rate.of, 50u) << id;
  EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << id << " " << trait.remark;
  EXPECT_LT(trait.runner_up_rate.agreeing, trait.rate.agreeing) << id << " " << trait.runner_up;
  EXPECT_EQ(findings.choices.at(id), alternative) << id;
}

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

// The policy's own rules and OpenGL's are found, all of them; but for those that it hides.
void expect_all_found(const Choices& rules, const std::vector<std::string>& hidden = {}) {
  const SampleFindings findings = findings_of(SampleRenderer(rules));
  Choices expected = rules;
  expected.insert(kOpenGl.begin(), kOpenGl.end());
  for (const auto& [rule, alternative] : expected)
    if (std::find(hidden.begin(), hidden.end(), rule) == hidden.end())
      expect_found(findings, rule, alternative);
  EXPECT_EQ(findings.drawn.not_drawn, 0u) << findings.drawn.first_failure;
  for (const char* id : {"triangle.coverage:multisampled", "line.coverage:multisampled",
                         "line.coverage:multisampled-wide", "line.multisampled:boundary"}) {
    const Trait& trait = trait_of(findings, id);
    EXPECT_GE(trait.rate.of, 100u) << id;
    EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << id;
  }
}

template <class Values>
void expect_each_found(const char* rule, const Values& values,
                       const std::vector<std::string>& hidden = {}) {
  for (const auto value : values) {
    SCOPED_TRACE(std::string(rule) + "=" + name_of(value));
    expect_all_found({{rule, name_of(value)}}, hidden);
  }
}

TEST(SampleMeasurement, FindsOpenGlsOwnRules) {
  expect_all_found({});
}

TEST(SampleMeasurement, FindsEveryPlacement) {
  for (const char* name :
       {"ordered-grid", "centre", "mirrored-x", "mirrored-y", "turned", "swapped"}) {
    SCOPED_TRACE(name);
    // With all samples in one place no mask is partial: nothing tells centroids apart.
    const bool is_centre = std::string(name) == "centre";
    const SampleFindings findings = findings_under({{"sample.positions", name}});
    expect_found(findings, "sample.positions", name);
    ASSERT_EQ(findings.profile.positions.size(), 1u);
    EXPECT_EQ(findings.profile.positions[0].placement, name);
    EXPECT_TRUE(std::any_of(
        findings.profile.positions[0].positions.begin(),
        findings.profile.positions[0].positions.end(),
        [](const MeasuredPosition& one) { return one.is_measured && !one.is_as_reported(); }));
    if (!is_centre) expect_found(findings, "attribute.centroid", "centre-or-first");
    const Trait& triangles = trait_of(findings, "triangle.coverage:multisampled");
    EXPECT_EQ(triangles.rate.agreeing, triangles.rate.of);
  }
}

TEST(SampleMeasurement, FindsEveryLine) {
  expect_each_found("line.multisampled", all_multisampled_lines());
}

TEST(SampleMeasurement, FindsWhetherSwitchAndMaskAreHonoured) {
  expect_each_found("sample.enable", all_multisample_switches());
  // Without the mask all samples of a pixel are alike, and nothing tells how they are resolved.
  expect_all_found({{"sample.mask", "ignored"}}, {"sample.resolve"});
}

TEST(SampleMeasurement, FindsEveryShadingRate) {
  expect_each_found("sample.shading-rate",
                    std::vector{ShadingRate::as_needed, ShadingRate::per_pixel});
  // Where the shader always runs for each sample, there is one place for attributes.
  const SampleFindings findings = findings_under({{"sample.shading-rate", "per-sample"}});
  expect_found(findings, "sample.shading-rate", "per-sample");
}

TEST(SampleMeasurement, FindsEveryLocation) {
  expect_each_found("attribute.location", all_plain_locations());
  expect_each_found("attribute.centroid", all_centroid_locations());
  expect_each_found("sample.depth", all_depth_locations());
}

TEST(SampleMeasurement, FindsEveryAlphaToCoverage) {
  expect_each_found("sample.alpha-to-coverage", all_alpha_to_coverages());
}

TEST(SampleMeasurement, FindsEveryResolve) {
  expect_each_found("sample.resolve", all_resolve_methods());
}

TEST(SampleMeasurement, SaysWhereSeveralSamplesAreNotAsOne) {
  const Choices rules{{"triangle.fill-rule", "right-top"}, {"triangle.snap", "8-half-even"}};
  const SampleFindings findings =
      findings_of(SampleRenderer(rules),
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
  EXPECT_FALSE(findings.choices.contains("triangle.fill-rule"));
}

TEST(SampleMeasurement, FindsLinesThatAreInterpolatedOtherwiseThanWithOneSample) {
  const SampleFindings findings =
      findings_of(SampleRenderer({}), {{"attribute.smooth", "major-axis"}});
  const Trait& trait = trait_of(findings, "attribute.smooth:multisampled");
  EXPECT_EQ(trait.alternative, "projection");
  EXPECT_EQ(trait.rate.agreeing, trait.rate.of);
  EXPECT_EQ(trait.remark, "not as with one sample: major-axis");
  expect_found(findings, "attribute.location", "centre");
}

TEST(SampleMeasurement, FindsPositionsOfEveryNumberOfSamples) {
  const SampleFindings findings =
      findings_of(SampleRenderer({{"triangle.snap", "4-half-even"}}, {}, {2, 4, 8, 16}),
                  {{"triangle.snap", "4-half-even"}});
  ASSERT_EQ(findings.profile.positions.size(), 4u);
  for (const MeasuredPositions& measured : findings.profile.positions) {
    EXPECT_EQ(measured.placement, "as-reported") << measured.samples;
    ASSERT_EQ(measured.positions.size(), static_cast<std::size_t>(measured.samples));
    for (const MeasuredPosition& one : measured.positions) {
      EXPECT_TRUE(one.is_as_reported());
      EXPECT_LE(one.x.high - one.x.low, Fixed::from_raw(Fixed::kOne / 16));
    }
  }
  EXPECT_EQ(findings.profile.samples, 4);
  expect_found(findings, "sample.positions", "as-reported");
}

TEST(SampleMeasurement, TellsAPlaceThatIsNotReported) {
  // Sample 2 covers what sample 1 covers.
  const SampleFindings findings =
      findings_of(SampleRenderer({}, [](const Scene&, Rendering& rendering) {
        for (Fragment& fragment : rendering.fragments)
          fragment.coverage = (fragment.coverage & ~4u) | (fragment.coverage & 2u) << 1;
        std::erase_if(rendering.fragments,
                      [](const Fragment& fragment) { return fragment.coverage == 0; });
      }));
  const MeasuredPositions& measured = findings.profile.positions.at(0);
  EXPECT_EQ(measured.placement, "");
  EXPECT_TRUE(measured.positions[1].is_as_reported());
  EXPECT_TRUE(measured.positions[2].is_measured);
  EXPECT_FALSE(measured.positions[2].is_as_reported());
  EXPECT_EQ(trait_of(findings, "sample.positions").remark, "sweeps find nothing catalogued");
  EXPECT_THAT(sample_profile_text(findings.profile), HasSubstr("NOT EQUAL"));
}

TEST(SampleMeasurement, TellsInvocationsAndPlaces) {
  const SampleFindings findings = findings_under({{"attribute.centroid", "mean-covered"}});
  ASSERT_EQ(findings.profile.invocations.size(), 13u);
  for (const InvocationRow& row : findings.profile.invocations) {
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
  for (const InvocationRow& row : findings_under({}).profile.invocations) {
    EXPECT_EQ(row.at_sample, row.asked == "sample" || row.asked == "share 1");
    EXPECT_FALSE(row.is_violation());
  }
  // Centroid attributes stay at the centre, however often the shader runs.
  const SampleFindings findings =
      findings_of(SampleRenderer({}, [](const Scene& scene, Rendering& rendering) {
        if (scene.draws[0].multisampling.location != AttributeLocation::centroid) return;
        for (Fragment& fragment : rendering.fragments) {
          fragment.color[0] = (fragment.x + 0.5) / kPlainSize;
          fragment.color[1] = (fragment.y + 0.5) / kPlainSize;
        }
      }));
  for (const InvocationRow& row : findings.profile.invocations)
    EXPECT_EQ(row.is_violation(), row.asked == "share 1" && row.location == "centroid");
  EXPECT_THAT(sample_profile_text(findings.profile), HasSubstr("violation of rulings 29 and 30"));
}

TEST(SampleMeasurement, TellsTheMasksOfAlphas) {
  const SampleFindings findings = findings_under({{"sample.alpha-to-coverage", "above-quotient"}});
  const auto& runs = findings.profile.alphas;
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
  const Trait right = trait_of(findings_of(SampleRenderer({})), "sample.alpha-to-coverage:own");
  EXPECT_GT(right.rate.of, 500u);
  EXPECT_EQ(right.rate.agreeing, right.rate.of);
  const SampleFindings wrong = findings_of(SampleRenderer({}, other));
  const Trait& trait = trait_of(wrong, "sample.alpha-to-coverage:own");
  EXPECT_LT(trait.rate.agreeing, trait.rate.of);
  EXPECT_EQ(trait.alternative, "not each by its own alpha");
  EXPECT_THAT(trait.remark, HasSubstr("violation of ruling 33"));
  EXPECT_EQ(wrong.choices.at("sample.alpha-to-coverage"), "proportional");
}

TEST(SampleMeasurement, CountsWhatNoAlternativeYields) {
  const SampleFindings findings =
      findings_of(SampleRenderer({}, [](const Scene&, Rendering& rendering) {
        for (std::uint8_t& value : rendering.pixels) value = static_cast<std::uint8_t>(value ^ 128);
      }));
  const Trait& trait = trait_of(findings, "sample.resolve");
  EXPECT_LT(trait.rate.share(), 0.2);
  EXPECT_THAT(trait.remark, HasSubstr("nothing catalogued yields"));
}

TEST(SampleMeasurement, SaysWhyThereIsNothingToMeasure) {
  const SampleFindings none = findings_of(SampleRenderer({}, {}, {}));
  EXPECT_EQ(none.profile.unavailable, "not so many");
  EXPECT_EQ(none.profile.counts.size(), 4u);
  EXPECT_TRUE(none.choices.empty());
  EXPECT_TRUE(none.traits.empty());
  EXPECT_EQ(none.drawn.not_drawn, 0u);
  EXPECT_THAT(sample_profile_text(none.profile), HasSubstr("not measured: not so many"));
  EXPECT_EQ(sample_profile_json(none.profile)["unavailable"], "not so many");

  const SampleFindings window = findings_of(SampleRenderer({}), {}, Surface::window);
  EXPECT_EQ(window.profile.unavailable, "a window's samples cannot be chosen");
}

TEST(SampleMeasurement, WritesWhatWasMeasured) {
  const SampleFindings findings = findings_of(SampleRenderer({}));
  const std::string text = sample_profile_text(findings.profile);
  EXPECT_THAT(text, HasSubstr("measured with 4 samples"));
  EXPECT_THAT(text, HasSubstr(" 2 samples: not so many\n"));
  EXPECT_THAT(text, HasSubstr("sample  1: reported (0.875, 0.375), found in x "));
  const auto json = sample_profile_json(findings.profile);
  EXPECT_EQ(json["counts"][0]["made"], false);
  EXPECT_EQ(json["counts"][1]["made"], true);
  EXPECT_EQ(json["positions"][0]["placement"], "as-reported");
  EXPECT_EQ(json["positions"][0]["positions"][3]["equal"], true);
  EXPECT_EQ(json["invocations"].size(), 13u);
  EXPECT_EQ(json["alpha_to_coverage"].size(), 5u);
}

}  // namespace
}  // namespace edgecase
