// SPDX-License-Identifier: MIT
//
// The measurement of textures measured: what is put wrong in the exact rasterizer must be named.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>

#include "profile/textures/textures.h"
#include "raster/rasterizer.h"
#include "tests/profile/texture_findings.h"

namespace edgecase {
namespace {

TEST(TextureMeasurement, SaysThatNoChainIsReported) {
  const SurfaceFindings findings = findings_among(
      {"mip chain "}, {}, [](const Task&, Rendering& rendering) { rendering.mip_chains.clear(); });
  EXPECT_EQ(trait_of(findings, "mipmap.filter").remark, "no chain is reported");
  EXPECT_FALSE(findings.choices.contains("mipmap.filter"));
}

// Of textures of 8 bits one thing, of others another: the policy has what holds for the former.
TEST(TextureMeasurement, TellsFormatsApart) {
  const Policy of_codes =
      policy_of({{"texture.level-weight", "floor-8"}, {"texture.texel-grid", "nearest-8"}});
  const SurfaceFindings findings =
      findings_among({"texture.level-weight", "texture.texel-grid", "ramp "}, {},
                     [&](const Task& task, Rendering& rendering) {
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
  for (const LevelResiduals& row : findings.levels) EXPECT_LT(row.found().largest, 1e-9);
}

// What is filtered in codes is rounded to codes: that hides no rule.
TEST(TextureMeasurement, FindsRulesThroughCodes) {
  const Choices rules{{"texture.level-weight", "floor-8"}, {"texture.texel-grid", "linear-even-8"}};
  const SurfaceFindings findings =
      findings_among({"texture.level-weight", "texture.texel-grid"}, rules,
                     [](const Task& task, Rendering& rendering) {
                       if (task.scene->textures[0]->format != TextureFormat::rgba8) return;
                       for (Fragment& fragment : rendering.fragments)
                         for (double& c : fragment.color) c = std::nearbyint(c * 255) / 255;
                     });
  for (const auto& [rule, alternative] : rules) expect_found(findings, rule, alternative);
}

TEST(TextureMeasurement, TellsTiesOfFootprintsAndOfGivenLevelsApart) {
  const Policy up = policy_of({{"texture.nearest-level", "up-at-ties"}});
  const SurfaceFindings findings =
      findings_among({"texture.nearest-level"}, {}, [&](const Task& task, Rendering& rendering) {
        if (task.scene->draws[0].texture->lookup.kind == LookupKind::lod)
          rendering = rasterize(*task.scene, up);
      });
  expect_found(findings, "texture.nearest-level", "down-at-ties");
  EXPECT_EQ(trait_of(findings, "texture.nearest-level:footprint").alternative, "down-at-ties");
  EXPECT_EQ(trait_of(findings, "texture.nearest-level:lod").alternative, "up-at-ties");
}

TEST(TextureMeasurement, SaysThatAnisotropyIsNotCatalogued) {
  const SurfaceFindings findings =
      findings_among({"texture.anisotropy"}, {}, [](const Task& task, Rendering& rendering) {
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
  const SurfaceFindings findings =
      findings_among({"texture.wrap"}, {}, [](const Task& task, Rendering& rendering) {
        if (task.id.rfind("texture.wrap/", 0) == 0) rendering.fragments[0].color[0] += 1;
      });
  EXPECT_NE(trait_of(findings, "texture.wrap").remark.find("nothing catalogued yields "),
            std::string::npos);
}

// Not told by queries: ramps themselves do.
TEST(TextureMeasurement, NeedsNoQueries) {
  const Choices rules{{"texture.scale-factor", "largest-partial"}, {"texture.log2", "mantissa-8"}};
  const SurfaceFindings findings =
      findings_among({"level of detail ", "ramp "}, rules, [](const Task&, Rendering& rendering) {
        for (FragmentDetail& detail : rendering.details) detail.level_of_detail.reset();
      });
  for (const auto& [rule, alternative] : rules) expect_found(findings, rule, alternative);
  EXPECT_EQ(findings.levels.size(), values_of<RampKind>().size());
  for (const LevelResiduals& row : findings.levels) EXPECT_EQ(row.source, LevelSource::color);
}

// Off by a quarter of a level at one pixel, where the primitive is drawn alone too, or not.
TEST(TextureMeasurement, NamesTheWorstFragment) {
  constexpr PixelPosition kPixel{13, 21};
  for (const bool alone : {true, false}) {
    const SurfaceFindings findings =
        findings_among({"ramp ", "alone/"}, {}, [&](const Task& task, Rendering& rendering) {
          if (task.id != "ramp rotated/00000" && !(alone && task.id.rfind("alone/", 0) == 0))
            return;
          for (const Fragment& fragment : rendering.fragments)
            if (PixelPosition{fragment.x, fragment.y} == kPixel)
              rendering.details[static_cast<std::size_t>(fragment.detail)]
                  .level_of_detail.value()[1] += 0.25;
        });
    for (const LevelResiduals& row : findings.levels) {
      const FormulaResidual& found = row.found();
      if (row.ramp != name_of(RampKind::rotated) || row.source != LevelSource::query) {
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
  // findings_of asks the same of the least numbers.
  AlteredRenderer renderer({}, {});
  const SurfaceFindings findings = measured(kTextureSubject, renderer, {1, Surface::fbo, 6000});
  EXPECT_EQ(findings.drawn.scenes, kTextureSubject.scene_count(6000));
  EXPECT_EQ(findings.drawn.not_drawn, 0u);
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
  const SurfaceFindings findings = measured(kTextureSubject, renderer, {1, Surface::fbo, 100});
  EXPECT_EQ(findings.drawn.scenes, 0u);
  EXPECT_EQ(findings.drawn.not_drawn, kTextureSubject.scene_count(100));
  EXPECT_EQ(findings.drawn.first_failure, "unsupported: no textures");
  EXPECT_TRUE(findings.choices.empty());
  EXPECT_TRUE(findings.levels.empty());
}

TEST(TextureMeasurement, StopsWhenAskedTo) {
  AlteredRenderer renderer({}, {});
  const std::atomic<bool> stop = true;
  SurfaceFindings findings;
  EXPECT_THROW(
      measure_subject(kTextureSubject, renderer, {1, Surface::fbo, 100}, {}, &stop, findings),
      MeasurementStopped);
}

}  // namespace
}  // namespace edgecase
