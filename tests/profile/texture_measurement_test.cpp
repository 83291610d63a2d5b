// SPDX-License-Identifier: MIT
//
// The measurement of textures measured: the exact rasterizer under a policy must be found to follow
// it, and what is put wrong must be named.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "profile/textures/texture_measurement.h"
#include "raster/rasterizer.h"
#include "tests/profile/altered_renderer.h"

namespace edgecase {
namespace {

Policy policy_of(const Choices& rules) {
  Policy policy;
  policy.rules = rules;
  return policy;
}

TextureFindings findings_of(const Choices& rules, const Alter& alter = {},
                            Surface surface = Surface::fbo, std::uint64_t seed = 1) {
  AlteredRenderer renderer(policy_of(rules), alter);
  TextureMeasureQuestion question;
  question.seed = seed;
  question.surface = surface;
  question.scenes_per_kind = 100;
  question.found = resolve(policy_of(rules), surface);
  question.found.textures = TextureChoice{};
  return measure_textures(renderer, question, {}, nullptr);
}

const Trait& trait_of(const TextureFindings& findings, const std::string& id) {
  for (const Trait& trait : findings.traits)
    if (trait.id == id) return trait;
  ADD_FAILURE() << "no trait " << id;
  static const Trait none;
  return none;
}

// Found, agreed with by all that tells, and by nothing as well as by it.
void expect_found(const TextureFindings& findings, const std::string& id,
                  const std::string& alternative) {
  const Trait& trait = trait_of(findings, id);
  EXPECT_EQ(trait.alternative, alternative) << id;
  EXPECT_GT(trait.rate.of, 50u) << id;
  EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << id << " " << trait.remark;
  EXPECT_LT(trait.runner_up_rate.agreeing, trait.rate.agreeing) << id << " " << trait.runner_up;
  EXPECT_EQ(findings.choices.at(id), alternative) << id;
}

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

// The policy's own rules and OpenGL's are found, all of them.
void expect_all_found(const Choices& rules, Surface surface = Surface::fbo) {
  const TextureFindings findings = findings_of(rules, {}, surface);
  Choices expected = rules;
  expected.insert(kOpenGl.begin(), kOpenGl.end());
  for (const auto& [rule, alternative] : expected) expect_found(findings, rule, alternative);
  EXPECT_EQ(findings.choices, expected);
}

template <class Values>
void expect_each_found(const char* rule, const Values& values) {
  for (const auto value : values) {
    SCOPED_TRACE(std::string(rule) + "=" + name_of(value));
    expect_all_found({{rule, name_of(value)}});
  }
}

TEST(TextureMeasurement, FindsOpenGlsOwnRules) {
  for (const Surface surface : {Surface::fbo, Surface::window}) expect_all_found({}, surface);
}

TEST(TextureMeasurement, FindsEveryScaleFactor) {
  expect_each_found("texture.scale-factor", all_scale_factors());
}

TEST(TextureMeasurement, FindsEveryLogarithm) {
  expect_each_found("texture.log2", all_log2_methods());
}

TEST(TextureMeasurement, FindsEveryMethodOfDerivatives) {
  expect_each_found("texture.derivatives", all_derivative_methods());
}

TEST(TextureMeasurement, FindsScaleFactorLogarithmAndDerivativesTogether) {
  for (const Surface surface : {Surface::fbo, Surface::window}) {
    expect_all_found({{"texture.scale-factor", "largest-partial"},
                      {"texture.log2", "mantissa-8"},
                      {"texture.derivatives", "quad-coarse-top-left"}},
                     surface);
    expect_all_found({{"texture.scale-factor", "sum-of-partials"},
                      {"texture.log2", "linear-mantissa"},
                      {"texture.derivatives", "quad-coarse-bottom-right"}},
                     surface);
  }
}

TEST(TextureMeasurement, FindsEveryLevelWeight) {
  expect_each_found("texture.level-weight", all_level_weights());
}

TEST(TextureMeasurement, FindsEveryTexelGrid) {
  expect_each_found("texture.texel-grid", all_texel_grids());
}

TEST(TextureMeasurement, FindsEveryNearestLevel) {
  expect_each_found("texture.nearest-level", all_nearest_levels());
}

TEST(TextureMeasurement, FindsEveryCrossover) {
  expect_each_found("texture.crossover", all_crossovers());
}

TEST(TextureMeasurement, FindsEveryBias) {
  expect_each_found("texture.lod-bias", all_bias_choices());
}

TEST(TextureMeasurement, FindsEveryAnisotropicFilter) {
  expect_each_found("texture.anisotropy",
                    std::array{Anisotropy::extension, Anisotropy::gaussian_5, Anisotropy::none});
}

TEST(TextureMeasurement, FindsMirroredRepetitionThatIsNone) {
  expect_all_found({{"texture.wrap", "mirrored-as-repeat"}});
}

TEST(TextureMeasurement, FindsEveryMipChain) {
  for (const MipmapFilter filter : all_mipmap_filters())
    for (const char* srgb : {"linear", "codes"}) {
      // A single texel is rounded in no way.
      const char* rounding = filter == MipmapFilter::nearest ? "nearest-even" : "half-up";
      SCOPED_TRACE(std::string(name_of(filter)) + srgb);
      const TextureFindings findings = findings_of({{"mipmap.filter", name_of(filter)},
                                                    {"mipmap.rounding", rounding},
                                                    {"mipmap.srgb", srgb}});
      for (const char* id : {"mipmap.filter", "mipmap.filter:srgb8", "mipmap.filter:rgba32f"}) {
        EXPECT_EQ(trait_of(findings, id).alternative, name_of(filter)) << id;
        EXPECT_EQ(trait_of(findings, id).rate.agreeing, trait_of(findings, id).rate.of) << id;
        EXPECT_GT(trait_of(findings, id).rate.of, 100u) << id;
      }
      if (filter == MipmapFilter::nearest) continue;
      expect_found(findings, "mipmap.rounding", rounding);
      expect_found(findings, "mipmap.srgb", srgb);
    }
}

TEST(TextureMeasurement, FindsEveryRoundingOfChains) {
  for (const MipmapRounding rounding : all_mipmap_roundings())
    for (const MipmapFilter filter : {MipmapFilter::box, MipmapFilter::bilinear_centre}) {
      const TextureFindings findings =
          findings_of({{"mipmap.filter", name_of(filter)}, {"mipmap.rounding", name_of(rounding)}});
      expect_found(findings, "mipmap.rounding", name_of(rounding));
      expect_found(findings, "mipmap.filter", name_of(filter));
    }
}

TEST(TextureMeasurement, SaysThatNoChainIsTold) {
  const TextureFindings findings =
      findings_of({}, [](const Task&, Rendering& rendering) { rendering.mip_chains.clear(); });
  EXPECT_EQ(trait_of(findings, "mipmap.filter").remark, "no chain is told");
  EXPECT_FALSE(findings.choices.contains("mipmap.filter"));
}

// Of textures of 8 bits one thing, of others another: the policy has what holds for the former.
TEST(TextureMeasurement, TellsFormatsApart) {
  const Policy of_codes =
      policy_of({{"texture.level-weight", "floor-8"}, {"texture.texel-grid", "nearest-8"}});
  const TextureFindings findings = findings_of({}, [&](const Task& task, Rendering& rendering) {
    if (task.scene->textures[0]->format == TextureFormat::rgba8)
      rendering = rasterize(*task.scene, of_codes);
  });
  expect_found(findings, "texture.level-weight", "floor-8");
  expect_found(findings, "texture.texel-grid", "nearest-8");
  for (const char* format : {"srgb8", "rgba32f"}) {
    EXPECT_EQ(trait_of(findings, std::string("texture.level-weight:") + format).alternative,
              "exact");
    EXPECT_EQ(trait_of(findings, std::string("texture.texel-grid:") + format).alternative, "none");
  }
  // The levels of ramps are those of floats: nothing is cut to 8 bits.
  for (const LevelResiduals& row : findings.residuals) EXPECT_LT(row.found().largest, 1e-9);
}

// What is filtered in codes is rounded to codes: that hides no rule.
TEST(TextureMeasurement, FindsRulesThroughCodes) {
  const Choices rules{{"texture.level-weight", "floor-8"}, {"texture.texel-grid", "linear-even-8"}};
  const TextureFindings findings = findings_of(rules, [](const Task& task, Rendering& rendering) {
    if (task.scene->textures[0]->format != TextureFormat::rgba8) return;
    for (Fragment& fragment : rendering.fragments)
      for (double& c : fragment.color) c = std::nearbyint(c * 255) / 255;
  });
  for (const auto& [rule, alternative] : rules) expect_found(findings, rule, alternative);
}

TEST(TextureMeasurement, TellsTiesOfFootprintsAndOfGivenLevelsApart) {
  const Policy up = policy_of({{"texture.nearest-level", "up-at-ties"}});
  const TextureFindings findings = findings_of({}, [&](const Task& task, Rendering& rendering) {
    if (task.scene->draws[0].texture->lookup.kind == LookupKind::lod)
      rendering = rasterize(*task.scene, up);
  });
  expect_found(findings, "texture.nearest-level", "down-at-ties");
  EXPECT_EQ(trait_of(findings, "texture.nearest-level:footprint").alternative, "down-at-ties");
  EXPECT_EQ(trait_of(findings, "texture.nearest-level:lod").alternative, "up-at-ties");
}

TEST(TextureMeasurement, SaysThatAnisotropyIsNotCatalogued) {
  const TextureFindings findings = findings_of({}, [](const Task& task, Rendering& rendering) {
    if (task.scene->draws[0].texture->sampler.max_anisotropy == 1) return;
    for (Fragment& fragment : rendering.fragments)
      fragment.color[0] = std::floor(fragment.color[0]);
  });
  const Trait& trait = trait_of(findings, "texture.anisotropy");
  EXPECT_EQ(trait.alternative, "not catalogued");
  EXPECT_FALSE(trait.remark.empty());
  EXPECT_FALSE(findings.choices.contains("texture.anisotropy"));
}

TEST(TextureMeasurement, SaysWhatNothingCataloguedYields) {
  const TextureFindings findings = findings_of({}, [](const Task& task, Rendering& rendering) {
    if (task.id.rfind("texture.wrap/", 0) == 0) rendering.fragments[0].color[0] += 1;
  });
  EXPECT_NE(trait_of(findings, "texture.wrap").remark.find("nothing catalogued yields "),
            std::string::npos);
}

// Not told by queries: ramps themselves do.
TEST(TextureMeasurement, NeedsNoQueries) {
  const Choices rules{{"texture.scale-factor", "largest-partial"}, {"texture.log2", "mantissa-8"}};
  const TextureFindings findings = findings_of(rules, [](const Task&, Rendering& rendering) {
    for (FragmentDetail& detail : rendering.details) detail.has_level_of_detail = false;
  });
  for (const auto& [rule, alternative] : rules) expect_found(findings, rule, alternative);
  EXPECT_EQ(findings.residuals.size(), all_ramp_kinds().size());
  for (const LevelResiduals& row : findings.residuals) EXPECT_EQ(row.source, LevelSource::color);
}

// Off by a quarter of a level at one pixel, where the primitive is drawn alone too, or not.
TEST(TextureMeasurement, NamesTheWorstFragment) {
  constexpr PixelPosition kPixel{13, 21};
  for (const bool alone : {true, false}) {
    const TextureFindings findings = findings_of({}, [&](const Task& task, Rendering& rendering) {
      if (task.id != "ramp rotated/00000" && !(alone && task.id.rfind("alone/", 0) == 0)) return;
      for (const Fragment& fragment : rendering.fragments)
        if (PixelPosition{fragment.x, fragment.y} == kPixel)
          rendering.details[static_cast<std::size_t>(fragment.detail)].level_of_detail[1] += 0.25;
    });
    for (const LevelResiduals& row : findings.residuals) {
      const FormulaResidual& found = row.found();
      if (row.kind != RampKind::rotated || row.source != LevelSource::query) {
        EXPECT_LT(found.largest, 1e-9);
        continue;
      }
      EXPECT_NEAR(found.largest, 0.25, 1e-9);
      ASSERT_TRUE(found.worst);
      EXPECT_EQ(found.worst->id, "ramp rotated/00000");
      EXPECT_EQ(found.worst->pixel, kPixel);
      EXPECT_EQ(primitives_of(found.worst->scene).size(), alone ? 1u : 128u);
      EXPECT_EQ(found.worst->primitive == 0, alone);
    }
  }
}

TEST(TextureMeasurement, DrawsAsManyScenesAsItSays) {
  for (const std::size_t count : {std::size_t{100}, std::size_t{6000}}) {
    AlteredRenderer renderer({}, {});
    TextureMeasureQuestion question;
    question.scenes_per_kind = count;
    std::size_t seen = 0;
    const TextureFindings findings = measure_textures(
        renderer, question, [&](std::size_t more) { seen += more; }, nullptr);
    EXPECT_EQ(findings.scenes, texture_scene_count(count));
    EXPECT_EQ(seen, findings.scenes);
    EXPECT_EQ(findings.not_drawn, 0u);
  }
}

TEST(TextureMeasurement, SaysWhatIsNotDrawn) {
  class NoTextures final : public Renderer {
   public:
    const RendererInfo& info() const override {
      static const RendererInfo info{"no textures", "", "", "", 8, {}};
      return info;
    }
    void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
      for (std::size_t i = 0; i < tasks.size(); ++i)
        sink(i, Failure{FailureKind::unsupported, "no textures"});
    }
  };
  NoTextures renderer;
  TextureMeasureQuestion question;
  question.scenes_per_kind = 100;
  const TextureFindings findings = measure_textures(renderer, question, {}, nullptr);
  EXPECT_EQ(findings.scenes, 0u);
  EXPECT_EQ(findings.not_drawn, texture_scene_count(100));
  EXPECT_EQ(findings.first_failure, "unsupported: no textures");
  EXPECT_TRUE(findings.choices.empty());
  EXPECT_TRUE(findings.residuals.empty());
}

TEST(TextureMeasurement, StopsWhenAskedTo) {
  AlteredRenderer renderer({}, {});
  TextureMeasureQuestion question;
  question.scenes_per_kind = 100;
  const std::atomic<bool> stop = true;
  EXPECT_THROW(measure_textures(renderer, question, {}, &stop), MeasurementStopped);
}

}  // namespace
}  // namespace edgecase
