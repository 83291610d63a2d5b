// SPDX-License-Identifier: MIT
//
// The measurement of fragment operations measured: the exact rasterizer under a policy must be
// found to follow it, and what no alternative does must be said to fit none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "generate/random_scenes.h"
#include "profile/evidence/inference.h"
#include "profile/output/output.h"
#include "profile/profile.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/profile/found_traits.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

using Alter = std::function<void(const Scene&, Rendering&)>;
using Refuses = std::function<bool(const Scene&)>;

// The exact rasterizer under a policy, with something put wrong or refused.
class OutputRenderer final : public Renderer {
 public:
  explicit OutputRenderer(Choices rules, Alter alter = {}, Refuses refuses = {})
      : alter_(std::move(alter)), refuses_(std::move(refuses)) {
    policy_.rules = std::move(rules);
  }
  const RendererInfo& info() const override {
    static const RendererInfo info{"output", "", "", "output", 8, {}};
    return info;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const Scene& scene = *tasks[i].scene;
      if (refuses_ && refuses_(scene)) {
        sink(i, Failure{FailureKind::unsupported, "not this format"});
        continue;
      }
      Rendering rendering = rasterize(scene, policy_);
      if (alter_) alter_(scene, rendering);
      sink(i, std::move(rendering));
    }
  }

 private:
  Policy policy_;
  Alter alter_;
  Refuses refuses_;
};

SurfaceFindings findings_of(OutputRenderer renderer, Surface surface = Surface::fbo) {
  return measured(kOutputSubject, renderer, {1, surface, 1});
}

// Rows of alternatives that do not hide each other, as two steps of 24 bits and the exponent of one
// would; the first is OpenGL's own.
const std::vector<Choices> kPlanted{
    {{"blend.equation", "as-set"},
     {"blend.rounding", "once"},
     {"color.mask", "as-set"},
     {"depth.test", "as-set"},
     {"stencil.test", "as-set"},
     {"offset.slope", "length"},
     {"offset.unit", "step"},
     {"offset.exponent", "largest-depth"}},
    {{"blend.equation", "color-for-alpha"},
     {"blend.rounding", "source-first"},
     {"color.mask", "ignored"},
     {"depth.test", "unconverted"},
     {"stencil.test", "ignored"},
     {"offset.slope", "largest-partial"},
     {"offset.unit", "power"},
     {"offset.exponent", "doubled"}},
    {{"blend.equation", "swapped"},
     {"blend.rounding", "every-product"},
     {"depth.test", "ties-pass"},
     {"stencil.test", "one-sided"},
     {"offset.slope", "ignored"},
     {"offset.unit", "of-24-bits"},
     {"offset.exponent", "one"}},
    {{"blend.equation", "over-as-premultiplied"},
     {"blend.rounding", "shifted-products"},
     {"depth.test", "ties-fail"},
     {"stencil.test", "unmasked"},
     {"offset.unit", "four-steps"},
     {"offset.exponent", "as-fixed"}},
    {{"blend.equation", "over-as-straight"},
     {"depth.test", "ignored"},
     {"stencil.test", "stored-first"},
     {"offset.unit", "two-steps"}},
    {{"blend.equation", "factors-in-min-and-max"},
     {"stencil.test", "wrapping"},
     {"offset.slope", "sum-of-partials"},
     {"offset.unit", "ignored"},
     {"offset.exponent", "halved"}},
    {{"blend.equation", "source-alpha-in-min-and-max"},
     {"stencil.test", "write-mask-ignored"},
     {"offset.unit", "half-step"}},
    {{"blend.equation", "differences-wrapped"}, {"stencil.test", "once-a-draw"}},
    {{"stencil.test", "saturating"}}};

TEST(OutputMeasurement, FindsEveryAlternative) {
  for (const Choices& planted : kPlanted) {
    const SurfaceFindings findings = findings_of(OutputRenderer(planted));
    Choices expected = planted;
    expected.insert(kPlanted[0].begin(), kPlanted[0].end());
    for (const auto& [rule, alternative] : expected) expect_found(findings, rule, alternative);
    EXPECT_EQ(findings.drawn.not_drawn, 0u) << findings.drawn.first_failure;
    EXPECT_TRUE(findings.output.blending.empty());
    for (const OutputKind kind : values_of<OutputKind>()) {
      const Trait& trait = trait_of(findings, std::string("triangle.output:") + name_of(kind));
      EXPECT_GE(trait.rate.of, 50u);
      EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << text_of(trait.id) << " " << trait.remark;
    }
  }
}

// Of what is not blended nothing tells how it would be rounded.
TEST(OutputMeasurement, FindsThatBlendingIsIgnored) {
  const SurfaceFindings findings =
      findings_of(OutputRenderer(Choices{{"blend.equation", "ignored"}}));
  expect_found(findings, "blend.equation", "ignored");
  EXPECT_FALSE(findings.choices.contains("blend.rounding"));
}

TEST(OutputMeasurement, EveryAlternativeIsPlanted) {
  for (const auto& [rule, standard] : kPlanted[0])
    for (const std::string& name : names_of_alternatives(find_rule(rule)->id)) {
      if (rule == "blend.equation" && name == "ignored") continue;
      EXPECT_TRUE(std::any_of(kPlanted.begin(), kPlanted.end(),
                              [&, id = rule](const Choices& row) {
                                const auto found = row.find(id);
                                return found != row.end() && found->second == name;
                              }))
          << rule << "=" << name;
    }
}

TEST(OutputMeasurement, FindsTheSameOfWindows) {
  const SurfaceFindings findings =
      findings_of(OutputRenderer(Choices{{"blend.rounding", "source-first"}}), Surface::window);
  expect_found(findings, "blend.rounding", "source-first");
  expect_found(findings, "offset.unit", "step");
}

TEST(OutputMeasurement, SaysThatNoRoundingFits) {
  // What is blended comes out one code higher, now and then.
  const SurfaceFindings findings =
      findings_of(OutputRenderer({}, [](const Scene& scene, Rendering& rendering) {
        if (!scene.draws.back().operations.blending) return;
        for (std::uint8_t& value : rendering.pixels)
          if (value % 16 == 8) ++value;
      }));
  const Trait& trait = trait_of(findings, "blend.rounding");
  EXPECT_EQ(trait.alternative, kNoneFits);
  EXPECT_EQ(trait.runner_up, "once");
  EXPECT_LT(trait.runner_up_rate.agreeing, trait.runner_up_rate.of);
  EXPECT_EQ(trait.rate.agreeing + trait.runner_up_rate.agreeing, trait.rate.of);
  EXPECT_THAT(trait.remark, HasSubstr("nothing catalogued yields"));
  EXPECT_FALSE(findings.choices.contains("blend.rounding"));
  ASSERT_FALSE(findings.output.blending.empty());
  for (const BlendResidual& residual : findings.output.blending) {
    EXPECT_EQ(residual.off.begin()->first, 1);
    EXPECT_EQ(residual.off.size(), 1u);
  }
  EXPECT_THAT(output_profile_text(findings.output), HasSubstr("off by +1"));
}

TEST(OutputMeasurement, SaysThatNoUnitFits) {
  // Offsets of one and a half of the standard's.
  const SurfaceFindings findings =
      findings_of(OutputRenderer({}, [](const Scene& scene, Rendering& rendering) {
        const auto primitives = primitives_of(scene);
        for (Fragment& fragment : rendering.fragments) {
          const auto& offset =
              primitives[static_cast<std::size_t>(fragment.primitive)].state->polygon_offset;
          if (offset && scene.target.depth == DepthFormat::depth16)
            fragment.depth += static_cast<double>(offset->units) / 2 / 65535;
        }
      }));
  EXPECT_EQ(trait_of(findings, "offset.unit:depth16").alternative, kNoneFits);
  EXPECT_EQ(trait_of(findings, "offset.unit:depth24").alternative, "step");
  EXPECT_EQ(trait_of(findings, "offset.unit").alternative, kNoneFits);
  EXPECT_FALSE(findings.choices.contains("offset.unit"));
  for (const MeasuredUnit& unit : findings.output.units) {
    const double expected = unit.format == DepthFormat::depth16 ? 1.5 : 1;
    EXPECT_NEAR(unit.least, expected, 1e-5);
    EXPECT_NEAR(unit.largest, expected, 1e-5);
    EXPECT_GE(unit.depths, 5u);
  }
}

TEST(OutputMeasurement, SaysHowDepthsBecomeCodes) {
  const auto truncating = [](const Scene& scene, Rendering& rendering) {
    if (scene.target.depth != DepthFormat::depth16) return;
    for (const Fragment& fragment : rendering.fragments)
      rendering.depths[rendering.pixel_index(fragment.x, fragment.y)] =
          std::floor(fragment.depth * 65535) / 65535;
  };
  const SurfaceFindings findings = findings_of(OutputRenderer({}, truncating));
  EXPECT_EQ(trait_of(findings, "framebuffer.depth:depth16:swept").alternative, "truncate");
  EXPECT_EQ(trait_of(findings, "framebuffer.depth:depth24:swept").alternative, "nearest");
  EXPECT_EQ(trait_of(findings, "framebuffer.unorm8:swept").alternative, "nearest");
  const CodeEvidence& codes = findings.output.codes.at(1);
  EXPECT_EQ(codes.id, "depth16");
  ASSERT_EQ(codes.steps.size(), 1u);
  EXPECT_LT(codes.steps.at(0).least, 0.01);
  EXPECT_GT(codes.steps.at(0).largest, 0.99);
}

TEST(OutputMeasurement, LeavesOutFormatsThatAreNotThere) {
  const SurfaceFindings findings = findings_of(OutputRenderer(
      {}, {}, [](const Scene& scene) { return scene.target.depth == DepthFormat::depth24; }));
  const Trait& codes = trait_of(findings, "framebuffer.depth:depth24:swept");
  EXPECT_EQ(codes.alternative, "not available");
  EXPECT_EQ(codes.remark, "not this format");
  EXPECT_EQ(findings.drawn.not_drawn, 0u);
  expect_found(findings, "offset.unit", "step");
  EXPECT_EQ(trait_of(findings, "triangle.output:depth-tested").rate.share(), 1);

  const SurfaceFindings none = findings_of(OutputRenderer({}, {}, [](const Scene& scene) {
    return scene.target.depth != DepthFormat::none || scene.target.stencil != StencilFormat::none;
  }));
  EXPECT_EQ(trait_of(none, "depth.test").rate.of, 0u);
  EXPECT_FALSE(none.choices.contains("depth.test"));
  EXPECT_FALSE(none.choices.contains("stencil.test"));
  expect_found(none, "blend.rounding", "once");
}

TEST(OutputMeasurement, NamesTheFirstSceneThatIsNotAsTheProfileHasIt) {
  const SurfaceFindings findings =
      findings_of(OutputRenderer({}, [](const Scene& scene, Rendering& rendering) {
        if (scene.target.stencil != StencilFormat::none && scene.draws.size() < 7)
          ++rendering.stencils.back();
      }));
  const Trait& trait = trait_of(findings, "triangle.output:stencilled");
  EXPECT_EQ(trait.rate.agreeing, 0u);
  EXPECT_THAT(trait.remark, HasSubstr("first in scene 0: values of pixel"));
}

TEST(OutputMeasurement, WritesWhatWasMeasured) {
  const SurfaceFindings findings = findings_of(OutputRenderer({}));
  const std::string text = output_profile_text(findings.output);
  EXPECT_THAT(text, HasSubstr("depth24   one unit of offset is 1 to 1 the format's steps"));
  EXPECT_THAT(text, HasSubstr("depth32f  one unit of offset is 1 to 1 2^(-1 - 23)"));
  EXPECT_EQ(output_profile_text({}), "");
  const auto json = output_profile_json(findings.output);
  EXPECT_EQ(json["codes"][0]["format"], "unorm8");
  EXPECT_EQ(json["codes"][2]["bits"], 24);
  EXPECT_EQ(json["offset_units"].size(), 14u);
  EXPECT_EQ(json["blending"].size(), 0u);
  EXPECT_EQ(json["random_scenes"], 200);
}

}  // namespace
}  // namespace edgecase
