// SPDX-License-Identifier: MIT
#include "profile/output/output_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "generate/random_scenes.h"
#include "profile/output/blend_traits.h"
#include "profile/output/code_rounding.h"
#include "profile/output/offset_traits.h"
#include "profile/output/output_scenes.h"
#include "profile/output/output_traits.h"
#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

// Share of the number of random scenes of a kind, and the least number.
constexpr std::size_t kRandomShare = 20;
constexpr std::size_t kLeastRandom = 50;

std::size_t random_count(std::size_t scenes_per_kind) {
  return std::max(kLeastRandom, scenes_per_kind / kRandomShare);
}

using Drawn = std::vector<DrawnScene>;

void append(Drawn& all, Drawn more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

class OutputMeasurement {
 public:
  OutputMeasurement(Renderer& renderer, const OutputMeasureQuestion& question,
                    const ObservationProgress& progress, const std::atomic<bool>* stop)
      : question_(question),
        drawing_(renderer, progress, stop, output_scene_count(question.scenes_per_kind)),
        rules_(question.found) {}

  OutputFindings run() {
    find_colors();
    find_blending();
    find_formats();
    for (const DepthFormat format : formats_) find_codes(format);
    find_depth_test();
    find_stencil_test();
    find_offset();
    for (int kind = 0; kind < kOutputKinds; ++kind) find_agreement(static_cast<OutputKind>(kind));
    drawing_.finish();
    findings_.drawn = drawing_.counts();
    return std::move(findings_);
  }

 private:
  // A trait whose id is a rule's, and that an alternative fits, is followed from here on.
  void adopt(Trait trait) {
    const bool fits = trait.rate.of > 0 && trait.alternative != kNoneFits;
    if (fits && trait.id.find(':') == std::string::npos) {
      rules_[trait.id] = trait.alternative;
      findings_.choices[trait.id] = trait.alternative;
    }
    findings_.traits.push_back(std::move(trait));
  }

  // Found so far, or OpenGL's own.
  OutputChoice output() const {
    Policy policy;
    policy.rules = rules_;
    return resolve(policy, question_.surface).output;
  }

  void find_colors() {
    CodeTally codes("unorm8", 8);
    add_plain_colors(drawing_.told("plain colour", plain_color_scenes(question_.surface)), codes);
    findings_.profile.codes.push_back(codes.evidence());
    findings_.traits.push_back(codes.trait("framebuffer.unorm8:swept"));
  }

  void find_blending() {
    const auto [seed, surface] = std::pair{question_.seed, question_.surface};
    const Drawn blended = drawing_.told("blended", blend_scenes(seed, surface));
    adopt(infer_blend_method(blended));
    adopt(infer_blend_rounding(blended, output().blend.method));
    // Where no rounding fits, what it is compared with is the one that comes closest.
    BlendChoice closest = output().blend;
    const Trait& rounding = findings_.traits.back();
    parse_name(rounding.alternative == kNoneFits ? rounding.runner_up : rounding.alternative,
               closest.rounding);
    findings_.profile.blending = blend_residuals(blended, closest);
    adopt(infer_output_rule(name_of(RuleId::color_mask),
                            drawing_.told("colour mask", color_mask_scenes(seed, surface)),
                            rules_));
  }

  // Which depth formats are there, alone and beside stencil values.
  void find_formats() {
    for (const DepthFormat format : kDepthFormats) {
      const std::string refusal =
          drawing_.refusal_of(depth_test_scenes(question_.seed, question_.surface, format).front());
      if (refusal.empty())
        formats_.push_back(format);
      else
        findings_.traits.push_back({fmt::format("framebuffer.depth:{}:swept", name_of(format)),
                                    "not available",
                                    {},
                                    "",
                                    {},
                                    refusal});
    }
    for (const DepthFormat format :
         {DepthFormat::none, DepthFormat::depth24, DepthFormat::depth32f}) {
      const auto scenes = stencil_scenes(question_.seed, question_.surface, format);
      if (drawing_.refusal_of(scenes.front()).empty()) stencil_formats_.push_back(format);
    }
  }

  void find_codes(DepthFormat format) {
    const int bits = bits_of(format);
    if (bits == 0) return;  // Such a depth is the fragment's own.
    CodeTally codes(name_of(format), bits);
    const double largest = std::ldexp(1.0, bits) - 1;
    for (const auto& [scene, rendering] :
         drawing_.told(fmt::format("depth code {}", name_of(format)),
                       depth_code_scenes(question_.seed, question_.surface, format)))
      for (const Fragment& fragment : rendering.fragments)
        if (fragment.has_depth)
          codes.add(fragment.depth,
                    std::lround(rendering.depths[rendering.pixel_index(fragment.x, fragment.y)] *
                                largest));
    findings_.profile.codes.push_back(codes.evidence());
    findings_.traits.push_back(
        codes.trait(fmt::format("framebuffer.depth:{}:swept", name_of(format))));
  }

  void find_depth_test() {
    Drawn all;
    for (const DepthFormat format : formats_)
      append(all, drawing_.told(fmt::format("depth test {}", name_of(format)),
                                depth_test_scenes(question_.seed, question_.surface, format)));
    adopt(infer_output_rule(name_of(RuleId::depth_test), all, rules_));
  }

  void find_stencil_test() {
    Drawn all;
    for (const DepthFormat format : stencil_formats_)
      append(all, drawing_.told(fmt::format("stencil {}", name_of(format)),
                                stencil_scenes(question_.seed, question_.surface, format)));
    adopt(infer_output_rule(name_of(RuleId::stencil_test), all, rules_));
  }

  void find_offset() {
    Drawn fixed;
    Drawn floating;
    Drawn slopes;
    for (const DepthFormat format : formats_) {
      Drawn units = drawing_.told(fmt::format("offset {}", name_of(format)),
                                  offset_unit_scenes(question_.surface, format));
      append(slopes, drawing_.told(fmt::format("offset slope {}", name_of(format)),
                                   offset_slope_scenes(question_.seed, question_.surface, format)));
      for (MeasuredUnit& unit : measured_units(units)) findings_.profile.units.push_back(unit);
      if (bits_of(format) == 0) {
        floating = std::move(units);
        continue;
      }
      adopt(infer_offset(name_of(RuleId::offset_unit),
                         fmt::format("offset.unit:{}", name_of(format)),
                         OffsetPrecision::float_steps, units, rules_));
      append(fixed, std::move(units));
    }
    const auto adopt_rule = [&](const char* rule, OffsetPrecision precision, const Drawn& told) {
      adopt(infer_offset(rule, rule, precision, told, rules_));
    };
    adopt_rule(name_of(RuleId::offset_unit), OffsetPrecision::float_steps, fixed);
    adopt_rule(name_of(RuleId::offset_exponent), OffsetPrecision::inexact, floating);
    adopt_rule(name_of(RuleId::offset_slope), OffsetPrecision::inexact, slopes);
  }

  // The first of the formats that a kind of random scene can have; none: it cannot be drawn.
  std::optional<DepthFormat> format_for(OutputKind kind) const {
    if (kind == OutputKind::blended) return DepthFormat::none;
    const auto& formats = kind == OutputKind::stencilled ? stencil_formats_ : formats_;
    for (const DepthFormat format :
         {DepthFormat::depth24, DepthFormat::depth32f, DepthFormat::depth16})
      if (std::find(formats.begin(), formats.end(), format) != formats.end()) return format;
    return std::nullopt;
  }

  void find_agreement(OutputKind kind) {
    const auto format = format_for(kind);
    if (!format) return;
    std::vector<Scene> scenes;
    for (std::size_t i = 0; i < random_count(question_.scenes_per_kind); ++i)
      scenes.push_back(random_output_scene({question_.seed, kind, question_.surface, *format}, i));
    findings_.profile.random_scenes += scenes.size();
    const std::string name = name_of(kind);
    findings_.traits.push_back(output_agreement(
        "triangle.output:" + name, drawing_.told("random " + name, std::move(scenes)), rules_));
  }

  const OutputMeasureQuestion& question_;
  SceneDrawing drawing_;
  Choices rules_;  // those found, of coverage and values, too
  std::vector<DepthFormat> formats_;
  std::vector<DepthFormat> stencil_formats_;
  OutputFindings findings_;
};

}  // namespace

std::size_t output_scene_count(std::size_t scenes_per_kind) {
  std::size_t count = plain_color_scenes(Surface::fbo).size() +
                      color_mask_scenes(1, Surface::fbo).size() +
                      blend_scenes(1, Surface::fbo).size() + kDepthFormats.size() + 3 +
                      3 * stencil_scenes(1, Surface::fbo, DepthFormat::none).size() +
                      kOutputKinds * random_count(scenes_per_kind);
  for (const DepthFormat format : kDepthFormats) {
    count += depth_test_scenes(1, Surface::fbo, format).size() +
             offset_unit_scenes(Surface::fbo, format).size() +
             offset_slope_scenes(1, Surface::fbo, format).size();
    if (bits_of(format) > 0) count += depth_code_scenes(1, Surface::fbo, format).size();
  }
  return count;
}

OutputFindings measure_output(Renderer& renderer, const OutputMeasureQuestion& question,
                              const ObservationProgress& progress, const std::atomic<bool>* stop) {
  return OutputMeasurement(renderer, question, progress, stop).run();
}

}  // namespace edgecase
