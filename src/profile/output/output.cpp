// SPDX-License-Identifier: MIT
#include "profile/output/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "generate/random_scenes.h"
#include "rules/values/framebuffer.h"

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
  OutputMeasurement(const Question& question, SceneDrawing& drawing, SurfaceFindings& findings)
      : question_(question), drawing_(drawing), findings_(findings) {}

  void run() {
    find_colors();
    find_blending();
    find_formats();
    for (const DepthFormat format : formats_) find_codes(format);
    find_depth_test();
    find_stencil_test();
    find_offset();
    for (const OutputKind kind : values_of<OutputKind>()) find_agreement(kind);
  }

 private:
  // The choices found so far, or OpenGL's own.
  OutputChoice output() const {
    return resolve(policy_of(findings_.choices), question_.surface).output;
  }

  void find_colors() {
    CodeTally codes("unorm8", 8);
    add_plain_colors(drawing_.drawn("plain colour", plain_color_scenes(question_.surface)), codes);
    findings_.output.codes.push_back(codes.evidence());
    findings_.adopt(codes.trait({RuleId::framebuffer_unorm8, "swept"}));
  }

  void find_blending() {
    const auto [seed, surface] = std::pair{question_.seed, question_.surface};
    const Drawn blended = drawing_.drawn("blended", blend_scenes(seed, surface));
    findings_.adopt(infer_blend_method(blended));
    findings_.adopt(infer_blend_rounding(blended, output().blend.method));
    // If no rounding fits, the closest one is used for comparison.
    BlendChoice closest = output().blend;
    const Trait& rounding = findings_.traits.back();
    parse_name(rounding.alternative == kNoneFits ? rounding.runner_up : rounding.alternative,
               closest.rounding);
    findings_.output.blending = blend_residuals(blended, closest);
    findings_.adopt(infer_output_rule(
        RuleId::color_mask, drawing_.drawn("colour mask", color_mask_scenes(seed, surface)),
        findings_.choices));
  }

  // The depth formats of the surface, alone and together with stencil values.
  void find_formats() {
    for (const DepthFormat format : kDepthFormats) {
      const std::string refusal =
          drawing_.refusal_of(depth_test_scenes(question_.seed, question_.surface, format).front());
      if (refusal.empty())
        formats_.push_back(format);
      else
        findings_.adopt({swept(format), "not available", {}, "", {}, refusal});
    }
    for (const DepthFormat format :
         {DepthFormat::none, DepthFormat::depth24, DepthFormat::depth32f}) {
      const auto scenes = stencil_scenes(question_.seed, question_.surface, format);
      if (drawing_.refusal_of(scenes.front()).empty()) stencil_formats_.push_back(format);
    }
  }

  void find_codes(DepthFormat format) {
    const int bits = bits_of(format);
    if (bits == 0) return;  // floating point stores the depth unchanged
    CodeTally codes(name_of(format), bits);
    const double largest = std::ldexp(1.0, bits) - 1;
    for (const auto& [scene, rendering] :
         drawing_.drawn(fmt::format("depth code {}", name_of(format)),
                        depth_code_scenes(question_.seed, question_.surface, format)))
      for (const Fragment& fragment : rendering.fragments)
        if (fragment.has_depth)
          codes.add(fragment.depth,
                    std::lround(rendering.depths[rendering.pixel_index(fragment.x, fragment.y)] *
                                largest));
    findings_.output.codes.push_back(codes.evidence());
    findings_.adopt(codes.trait(swept(format)));
  }

  void find_depth_test() {
    Drawn all;
    for (const DepthFormat format : formats_)
      append(all, drawing_.drawn(fmt::format("depth test {}", name_of(format)),
                                 depth_test_scenes(question_.seed, question_.surface, format)));
    findings_.adopt(infer_output_rule(RuleId::depth_test, all, findings_.choices));
  }

  void find_stencil_test() {
    Drawn all;
    for (const DepthFormat format : stencil_formats_)
      append(all, drawing_.drawn(fmt::format("stencil {}", name_of(format)),
                                 stencil_scenes(question_.seed, question_.surface, format)));
    findings_.adopt(infer_output_rule(RuleId::stencil_test, all, findings_.choices));
  }

  void find_offset() {
    Drawn fixed;
    Drawn floating;
    Drawn slopes;
    for (const DepthFormat format : formats_) {
      Drawn units = drawing_.drawn(fmt::format("offset {}", name_of(format)),
                                   offset_unit_scenes(question_.surface, format));
      append(slopes,
             drawing_.drawn(fmt::format("offset slope {}", name_of(format)),
                            offset_slope_scenes(question_.seed, question_.surface, format)));
      for (MeasuredUnit& unit : measured_units(units)) findings_.output.units.push_back(unit);
      if (bits_of(format) == 0) {
        floating = std::move(units);
        continue;
      }
      findings_.adopt(infer_offset({RuleId::offset_unit, name_of(format)},
                                   OffsetPrecision::float_steps, units, findings_.choices));
      append(fixed, std::move(units));
    }
    adopt_offset(RuleId::offset_unit, OffsetPrecision::float_steps, fixed);
    adopt_offset(RuleId::offset_exponent, OffsetPrecision::inexact, floating);
    adopt_offset(RuleId::offset_slope, OffsetPrecision::inexact, slopes);
  }

  void adopt_offset(RuleId rule, OffsetPrecision precision, const Drawn& scenes) {
    findings_.adopt(infer_offset(rule, precision, scenes, findings_.choices));
  }

  // The first format for a kind of random scene; nothing: it cannot be drawn.
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
    findings_.output.random_scenes += scenes.size();
    const std::string name = name_of(kind);
    findings_.adopt(output_agreement(TraitId("triangle.output:" + name),
                                     drawing_.drawn("random " + name, std::move(scenes)),
                                     findings_.choices));
  }

  static TraitId swept(DepthFormat format) {
    return {RuleId::framebuffer_depth, fmt::format("{}:swept", name_of(format))};
  }

  const Question& question_;
  SceneDrawing& drawing_;
  std::vector<DepthFormat> formats_;
  std::vector<DepthFormat> stencil_formats_;
  SurfaceFindings& findings_;
};

std::size_t scene_count(std::size_t scenes_per_kind) {
  std::size_t count = plain_color_scenes(Surface::fbo).size() +
                      color_mask_scenes(1, Surface::fbo).size() +
                      blend_scenes(1, Surface::fbo).size() + kDepthFormats.size() + 3 +
                      3 * stencil_scenes(1, Surface::fbo, DepthFormat::none).size() +
                      values_of<OutputKind>().size() * random_count(scenes_per_kind);
  for (const DepthFormat format : kDepthFormats) {
    count += depth_test_scenes(1, Surface::fbo, format).size() +
             offset_unit_scenes(Surface::fbo, format).size() +
             offset_slope_scenes(1, Surface::fbo, format).size();
    if (bits_of(format) > 0) count += depth_code_scenes(1, Surface::fbo, format).size();
  }
  return count;
}

}  // namespace

const Subject kOutputSubject{
    scene_count, [](const Question& question, SceneDrawing& drawing, SurfaceFindings& findings) {
      OutputMeasurement(question, drawing, findings).run();
    }};

}  // namespace edgecase
