// SPDX-License-Identifier: MIT
#include "diff/values/location_causes.h"

#include <algorithm>

#include "rules/all_rules.h"

namespace edgecase {
namespace {

// Fragments whose colour depends on where it is evaluated.
bool has_place(const ValueContext& context, const Fragment& fragment) {
  const Draw& draw = *context.primitive_of(fragment).state;
  return fragment.has_color && is_multisampled(draw, context.scene.target) &&
         draw.interpolation != Interpolation::flat;
}

// Fragments whose depth does.
bool has_depth_place(const ValueContext& context, const Fragment& fragment) {
  return fragment.has_depth &&
         is_multisampled(*context.primitive_of(fragment).state, context.scene.target);
}

bool yields(const ValueContext& context, const Fragment& fragment, const LocationChoice& choice) {
  const Point place = context.place_of(fragment, choice);
  const PrimitiveAttributes& lawful = context.values_of(fragment).lawful;
  for (std::size_t c = 0; c < 4; ++c)
    if (!rounded_to_float(color_inexact(lawful, c, place, {fragment.x, fragment.y}))
             .contains(to_float(fragment.color[c])))
      return false;
  return true;
}

}  // namespace

Changes location_changes(const RuleChoices& chosen) {
  Changes changes = changes_beside(RuleId::attribute_location, chosen);
  const Changes more = changes_beside(RuleId::attribute_centroid, chosen);
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

LocationChoice locations_of(const Change& change, const RuleChoices& chosen) {
  return change.applied_to(chosen).values.locations;
}

bool FollowedLocation::explains(const ValueContext& context, const Fragment& fragment) const {
  return !cause.empty() && has_place(context, fragment) &&
         !yields(context, fragment, context.choices.values.locations);
}

bool yields_depth(const ValueContext& context, const Fragment& fragment, const Interpolant& depth,
                  const LocationChoice& choice) {
  const Draw& draw = *context.primitive_of(fragment).state;
  if (fragment_depth_is_zero(draw.multisampling, choice)) return fragment.depth == 0;
  const Interval interpolated =
      interpolate_inexact(depth, context.depth_place_of(fragment, choice));
  return rounded_to_float(clamped_depth(context.values_of(fragment).lawful, interpolated))
      .contains(to_float(fragment.depth));
}

bool FollowedDepth::explains(const ValueContext& context, const Fragment& fragment) const {
  return !cause.empty() && has_depth_place(context, fragment) &&
         !yields_depth(context, fragment, context.values_of(fragment).lawful.depth,
                       context.choices.values.locations);
}

FollowedDepth followed_depth(const ValueContext& context, const Rendering& rendered) {
  if (context.scene.target.samples == 1) return {};
  const auto all = [&](const LocationChoice& choice) {
    return std::ranges::all_of(rendered.fragments, [&](const Fragment& f) {
      return !has_depth_place(context, f) ||
             yields_depth(context, f, context.values_of(f).lawful.depth, choice);
    });
  };
  if (all(context.choices.values.locations)) return {};
  for (const Change& change : changes_beside(RuleId::sample_depth, context.choices))
    if (all(locations_of(change, context.choices)))
      return {change.id, change.id.rule, rule_of(change.id.rule).ruling};
  return {};
}

FollowedLocation followed_location(const ValueContext& context, const Rendering& rendered) {
  if (context.scene.target.samples == 1) return {};
  const auto all = [&](const LocationChoice& choice) {
    return std::ranges::all_of(rendered.fragments, [&](const Fragment& f) {
      return !has_place(context, f) || yields(context, f, choice);
    });
  };
  if (all(context.choices.values.locations)) return {};
  for (const Change& change : location_changes(context.choices))
    if (all(locations_of(change, context.choices)))
      return {change.id, change.id.rule, rule_of(change.id.rule).ruling};
  return {};
}

}  // namespace edgecase
