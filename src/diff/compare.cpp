// SPDX-License-Identifier: MIT
#include "diff/compare.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "diff/alternatives.h"
#include "diff/coverage_compare.h"
#include "diff/coverage_diff.h"
#include "diff/explanation.h"
#include "diff/legality.h"
#include "diff/texture_values.h"
#include "diff/value_diff.h"
#include "raster/rasterizer.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

bool reads_before(const Disagreement& a, const Disagreement& b) {
  return std::tie(a.y, a.x, a.primitive, a.kind, a.rule) <
         std::tie(b.y, b.x, b.primitive, b.kind, b.rule);
}

}  // namespace

Result compare(const Scene& scene, const Policy& policy, const Rendering& exact,
               const Rendering& rendered, const RendererFacts& facts) {
  const Surface surface = scene.target.surface;
  const RuleChoices choices = resolve(policy, surface);
  const int bits = latitude_bits(facts.reported_subpixel_bits);
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  const auto coverage = match_coverage(primitives.size(), exact, rendered);
  std::optional<RuleChoices> profile;
  if (facts.profile != nullptr) profile = resolve(*facts.profile, surface);

  Result result;
  result.pixels = rendered.pixels;
  result.refuted.assign(alternative_names().size(), '0');
  compare_coverage(
      {scene, primitives, coverage, choices, profile ? &*profile : nullptr, policy.latitude, bits},
      result);
  const ValueContext values(scene, primitives, choices, bits, policy.latitude);
  compare_fragment_values(values, rendered, result);
  compare_coordinates(values, rendered, result);
  compare_derivatives(values, rendered, result);
  compare_texture_lookups(values, rendered, profile ? &profile->textures : nullptr, result);
  compare_mip_chains(values, exact, rendered, result);
  // A renderer that was asked for coverage alone has neither pixels nor depths.
  if (!rendered.pixels.empty()) compare_pixels(values, rendered, result);
  if (!rendered.depths.empty()) compare_depths(values, rendered, result);
  std::sort(result.disagreements.begin(), result.disagreements.end(), reads_before);
  return result;
}

Result not_run(Failure failure) {
  Result result;
  result.verdict = Verdict::not_run;
  result.failure = std::move(failure);
  return result;
}

Figure scene_figure(const Scene& scene) {
  Figure figure;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const auto count = static_cast<std::size_t>(vertices_of(primitive.kind));
    Mark outline{MarkRole::primitive, count == 3, {}, std::to_string(primitive.index)};
    for (std::size_t i = 0; i < count; ++i) {
      const Point position = nearest_point(primitive.positions[i]);
      const char* about = primitive.vertices[i]->clip ? "about " : "";
      outline.points.push_back(position_of(position));
      figure.marks.push_back(
          {MarkRole::vertex, false, {position_of(position)}, about + format_point(position)});
    }
    figure.marks.push_back(std::move(outline));
  }
  return figure;
}

std::vector<PixelExplanation> explain_pixel(const Scene& scene, const Policy& policy, int x,
                                            int y) {
  const RuleChoices choices = resolve(policy, scene.target.surface);
  std::vector<PixelExplanation> result;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const CoverageChoice& choice = choices.of(primitive.kind);
    const auto pixels = covered_pixels(primitive, scene.target, choice);
    Explanation why = explain(primitive, {x, y}, choice);
    result.push_back({primitive.index,
                      std::find(pixels.begin(), pixels.end(), PixelPosition{x, y}) != pixels.end(),
                      coverage_rule_of(primitive.kind), std::move(why.text),
                      std::move(why.figure)});
  }
  return result;
}

}  // namespace edgecase
