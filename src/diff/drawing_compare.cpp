// SPDX-License-Identifier: MIT
#include "diff/drawing_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "diff/coverage/coverage_compare.h"
#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/legality.h"
#include "diff/findings/add_disagreement.h"
#include "diff/output/operations_compare.h"
#include "diff/samples/sample_values.h"
#include "diff/textures/texture_lookups.h"
#include "diff/textures/untold_colors.h"
#include "diff/values/offset_causes.h"
#include "diff/values/value_diff.h"
#include "rules/all_rules.h"
#include "rules/samples/sample_placement.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

// Compares the target's planes: with the last fragment of each sample or, if the scene has fragment
// operations, with the result of all of them.
void compare_planes(const ValueContext& values, const Rendering& rendered, Result& result) {
  const bool multisampled = rendered.samples > 1;
  const bool has_operations = has_fragment_operations(values.scene);
  // A renderer that was asked only for coverage sends neither pixels nor depths.
  if (!has_operations && !(multisampled ? rendered.sample_pixels : rendered.pixels).empty())
    compare_pixels(values, rendered, result);
  if (has_operations) compare_operations(values, rendered, result);
  if (multisampled) compare_invocations(values, rendered, result);
  if (multisampled && !rendered.pixels.empty()) compare_resolved_pixels(values, rendered, result);
  if (has_operations) return;
  if (multisampled && !rendered.hits.empty()) compare_sample_hits(values, rendered, result);
  if (!rendered.depths.empty()) compare_depths(values, rendered, result);
}

// Compares the values of fragments, and what they leave in the target.
void compare_values(const ValueContext& values, const Rendering& exact, const Rendering& rendered,
                    const RuleChoices* profile, Result& result) {
  compare_fragment_values(values, exact, rendered, result);
  compare_coordinates(values, exact, rendered, result);
  compare_derivatives(values, rendered, result);
  compare_texture_lookups(values, exact, rendered, profile ? &profile->textures : nullptr, result);
  compare_mip_chains(values, exact, rendered, result);
  compare_planes(values, rendered, result);
}

// The unit of polygon offset that fits most fragments. Notes what primitives show of it, unless the
// policy wants a slope that OpenGL forbids, which units would have to make up for.
Interval note_unit(const ValueContext& values, const Rendering& rendered, Result& result) {
  const SingleThing unit{SingleThing::Kind::offset_unit, bits_of(values.scene.target.depth), 0};
  const FollowedUnit followed = followed_fixed_unit(values, rendered);
  const OffsetSlope slope = values.choices.values.offset.slope;
  if (slope != OffsetSlope::length && slope != OffsetSlope::largest_partial) return followed.unit;
  std::set<std::pair<double, double>> different;
  for (const Interval shown : followed.shown)
    if (different.emplace(shown.low, shown.high).second)
      result.shown.push_back({unit, shown.low, shown.high});
  return followed.unit;
}

// Moves the mark of a disagreement about a sample to the sample's position.
void mark_sample(Disagreement& d, const SamplePositions& positions) {
  const auto sample = static_cast<std::size_t>(d.sample);
  if (d.kind != DisagreementKind::value || d.sample < 0 || sample >= positions.size()) return;
  for (Mark& mark : d.figure.marks)
    if (mark.role == MarkRole::sample)
      mark.points = {position_of(place_in({d.x, d.y}, positions[sample]))};
}

// Reports the first two samples that the renderer has at one place, unless the case places them.
void compare_places(const Target& target, const SamplePositions& reported, Result& result) {
  if (!target.sample_positions.empty()) return;
  for (std::size_t s = 1; s < reported.size(); ++s) {
    const auto first = std::ranges::find(reported, reported[s]);
    if (first == reported.begin() + static_cast<std::ptrdiff_t>(s)) continue;
    Disagreement d =
        value_disagreement({0, 0}, -1, RuleId::sample_positions, kRulingOnSharedPlaces);
    d.sample = static_cast<int>(s);
    const auto [x, y] = position_of(reported[s]);
    d.explanation = fmt::format(
        "samples {} and {} of each pixel lie at one place, ({}, {}) from its lower left corner, by "
        "what the renderer reports. Ruling {}",
        first - reported.begin(), s, x, y, kRulingOnSharedPlaces);
    add_disagreement(result, std::move(d));
    return;
  }
}

// True if what is only counted is a violation, whatever the run says: a stray that may be legal
// must show the right colour.
bool is_surely_gross(const Result& result) {
  return std::ranges::any_of(result.counted, [](const DisagreementClass& d) {
    return !is_legal(d) && !is_about_a_line(d) && legality_against(d.ruling) == Legality::illegal;
  });
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
                    rendered.sample_positions, facts.sizes, facts.likely_first},
                   result);
  ValueContext values(scene, primitives, choices, bits, policy.latitude(),
                      rendered.sample_positions);
  if (compared != Compared::all) {
    note_unit(values, rendered, result);
  } else {
    if (rendered.samples > 1) values.follow(followed_rate(values, rendered));
    values.follow_limits(facts.lookups);
    values.follow_fixed_unit(note_unit(values, rendered, result));
    if (is_surely_gross(result)) values.leave_strays_open(exact, rendered);
    std::optional<UntoldColors> untold;
    if (has_untold_colors(values, rendered)) {
      untold.emplace(values, exact, rendered);
      values.follow_lookups([&](const Fragment& fragment) { return untold->of(fragment); });
    }
    compare_values(values, exact, rendered, profile, result);
    compare_places(scene.target, rendered.sample_positions, result);
  }
  if (rendered.samples > 1)
    for (Disagreement& d : result.disagreements) mark_sample(d, exact.sample_positions);
  else
    for_each_class(result, [](DisagreementClass& d) { d.sample = 0; });
  return result;
}

}  // namespace edgecase
