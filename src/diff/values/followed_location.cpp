// SPDX-License-Identifier: MIT
#include "diff/values/followed_location.h"

#include <algorithm>
#include <span>

#include "diff/values/value_causes.h"
#include "rules/all_rules.h"
#include "rules/change_search.h"

namespace edgecase {

namespace {

constexpr RuleId kDepthRules[] = {RuleId::sample_depth};

// True if the fragment's colour depends on where it is evaluated.
bool has_place(const ValueContext& context, const Fragment& fragment) {
  const Draw& draw = *context.primitive_of(fragment).state;
  return fragment.has_color && is_multisampled(draw, context.scene.target) &&
         draw.interpolation != Interpolation::flat;
}

// True if the fragment's depth depends on where it is evaluated.
bool has_depth_place(const ValueContext& context, const Fragment& fragment) {
  return fragment.has_depth &&
         is_multisampled(*context.primitive_of(fragment).state, context.scene.target);
}

bool yields(const ValueContext& context, const Fragment& fragment, const LocationChoice& choice) {
  return yields_color(context.values_of(fragment).lawful, context.place_of(fragment, choice),
                      fragment);
}

// The first alternative of these rules under which every fragment passes, if not every one does
// under the policy's own choices.
template <class Followed, class Passes>
Followed followed_by_all(const ValueContext& context, const Rendering& rendered,
                         std::span<const RuleId> rules, const Passes& passes) {
  if (context.scene.target.samples == 1) return {};
  const auto all = [&](const LocationChoice& choice) {
    return std::ranges::all_of(rendered.fragments,
                               [&](const Fragment& f) { return passes(f, choice); });
  };
  if (all(context.choices.values.locations)) return {};
  const Cause cause =
      first_cause(changes_beside(rules, context.choices),
                  [&](const Change& change) { return all(locations_of(change, context.choices)); });
  if (cause.empty()) return {};
  return {cause, cause.rule(), rule_of(cause.rule()).ruling};
}

}  // namespace

bool FollowedLocation::explains(const ValueContext& context, const Fragment& fragment) const {
  return !cause.empty() && has_place(context, fragment) &&
         !yields(context, fragment, context.choices.values.locations);
}

bool FollowedDepth::explains(const ValueContext& context, const Fragment& fragment) const {
  return !cause.empty() && has_depth_place(context, fragment) &&
         !yields_depth(context, fragment, context.values_of(fragment).lawful.depth,
                       context.choices.values.locations);
}

FollowedDepth followed_depth(const ValueContext& context, const Rendering& rendered) {
  const auto passes = [&](const Fragment& f, const LocationChoice& choice) {
    return !has_depth_place(context, f) ||
           yields_depth(context, f, context.values_of(f).lawful.depth, choice);
  };
  return followed_by_all<FollowedDepth>(context, rendered, kDepthRules, passes);
}

FollowedLocation followed_location(const ValueContext& context, const Rendering& rendered) {
  const auto passes = [&](const Fragment& f, const LocationChoice& choice) {
    return !has_place(context, f) || yields(context, f, choice);
  };
  return followed_by_all<FollowedLocation>(context, rendered, kLocationRules, passes);
}

}  // namespace edgecase
