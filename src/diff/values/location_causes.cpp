// SPDX-License-Identifier: MIT
#include "diff/values/location_causes.h"

#include <fmt/format.h>

#include <algorithm>

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

std::vector<LocationChange> locations_beside(const LocationChoice& chosen) {
  std::vector<LocationChange> changes;
  for (const PlainLocation plain : values_of<PlainLocation>()) {
    if (plain == chosen.plain) continue;
    LocationChoice choice = chosen;
    choice.plain = plain;
    changes.push_back(
        {fmt::format("attribute.location={}", name_of(plain)), "attribute.location", 29, choice});
  }
  for (const CentroidLocation centroid : values_of<CentroidLocation>()) {
    if (centroid == chosen.centroid) continue;
    LocationChoice choice = chosen;
    choice.centroid = centroid;
    changes.push_back({fmt::format("attribute.centroid={}", name_of(centroid)),
                       "attribute.centroid", 30, choice});
  }
  return changes;
}

std::vector<LocationChange> depth_locations_beside(const LocationChoice& chosen) {
  std::vector<LocationChange> changes;
  for (const DepthLocation depth : values_of<DepthLocation>()) {
    if (depth == chosen.depth) continue;
    LocationChoice choice = chosen;
    choice.depth = depth;
    changes.push_back({fmt::format("sample.depth={}", name_of(depth)), "sample.depth", 18, choice});
  }
  return changes;
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
  for (const LocationChange& change : depth_locations_beside(context.choices.values.locations))
    if (all(change.choice)) return {change.cause, change.rule, change.ruling};
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
  for (const LocationChange& change : locations_beside(context.choices.values.locations))
    if (all(change.choice)) return {change.cause, change.rule, change.ruling};
  return {};
}

}  // namespace edgecase
