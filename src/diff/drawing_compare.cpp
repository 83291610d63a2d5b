// SPDX-License-Identifier: MIT
#include "diff/drawing_compare.h"

#include <optional>
#include <utility>
#include <vector>

#include "diff/coverage/coverage_compare.h"
#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/legality.h"
#include "diff/output/fate_compare.h"
#include "diff/textures/texture_values.h"
#include "diff/values/value_diff.h"
#include "raster/rasterizer.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

// What the target holds: by the last fragment of each sample, or by all that becomes of them.
void compare_planes(const ValueContext& values, const Rendering& rendered, Result& result) {
  const bool multisampled = rendered.samples > 1;
  const bool has_fates = has_fragment_operations(values.scene);
  // A renderer that was asked for coverage alone has neither pixels nor depths.
  if (!has_fates && !(multisampled ? rendered.sample_pixels : rendered.pixels).empty())
    compare_pixels(values, rendered, result);
  if (has_fates) compare_fates(values, rendered, result);
  if (multisampled) compare_invocations(values, rendered, result);
  if (multisampled && !rendered.pixels.empty()) compare_resolved_pixels(values, rendered, result);
  if (has_fates) return;
  if (multisampled && !rendered.hits.empty()) compare_sample_hits(values, rendered, result);
  if (!rendered.depths.empty()) compare_depths(values, rendered, result);
}

// What fragments tell beside where they are, and what comes of it.
void compare_values(const ValueContext& values, const Rendering& exact, const Rendering& rendered,
                    const RuleChoices* profile, Result& result) {
  compare_fragment_values(values, rendered, result);
  compare_coordinates(values, rendered, result);
  compare_derivatives(values, rendered, result);
  compare_texture_lookups(values, exact, rendered, profile ? &profile->textures : nullptr, result);
  compare_mip_chains(values, exact, rendered, result);
  compare_planes(values, rendered, result);
}

// A disagreement on what a sample holds is shown where the sample lies.
void mark_sample(Disagreement& d, const SamplePositions& positions) {
  const auto sample = static_cast<std::size_t>(d.sample);
  if (d.kind != DisagreementKind::value || d.sample < 0 || sample >= positions.size()) return;
  for (Mark& mark : d.figure.marks)
    if (mark.role == MarkRole::sample)
      mark.points = {position_of(place_in({d.x, d.y}, positions[sample]))};
}

}  // namespace

Result compare_drawing(const Drawing& drawing, const AlternativeSet& refuted, Compared compared) {
  const auto& [scene, policy, exact, rendered, facts] = drawing;
  const Surface surface = scene.target.surface;
  const RuleChoices& choices = policy.on(surface);
  const int bits = latitude_bits(facts.reported_subpixel_bits);
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  const auto coverage = match_coverage(primitives.size(), exact, rendered);
  const RuleChoices* const profile =
      facts.profile != nullptr ? &facts.profile->on(surface) : nullptr;

  Result result;
  result.refuted = refuted;
  compare_coverage({scene, primitives, coverage, choices, profile, policy.latitude(), bits, true,
                    rendered.sample_positions, facts.sizes},
                   result);
  if (compared == Compared::all) {
    ValueContext values(scene, primitives, choices, bits, policy.latitude(),
                        rendered.sample_positions);
    if (rendered.samples > 1) values.follow(followed_rate(values, rendered));
    values.follow_limits(facts.lookups);
    values.follow_fixed_unit(followed_fixed_unit(values, rendered));
    compare_values(values, exact, rendered, profile, result);
  }
  for (Disagreement& d : result.disagreements) {
    if (rendered.samples > 1)
      mark_sample(d, exact.sample_positions);
    else
      d.sample = 0;
  }
  return result;
}

}  // namespace edgecase
