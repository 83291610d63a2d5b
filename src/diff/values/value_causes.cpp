// SPDX-License-Identifier: MIT
#include "diff/values/value_causes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

#include "diff/values/sample_writers.h"
#include "rules/all_rules.h"
#include "rules/change_search.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

constexpr RuleId kRules[] = {RuleId::attribute_smooth, RuleId::attribute_perspective,
                             RuleId::attribute_positions};
// Where attributes are evaluated, and where depths.
constexpr RuleId kLocationRules[] = {RuleId::attribute_location, RuleId::attribute_centroid};
constexpr RuleId kDepthRules[] = {RuleId::sample_depth};

bool yields_color(const PrimitiveAttributes& attributes, Point place, const Fragment& fragment) {
  for (std::size_t c = 0; c < 4; ++c)
    if (!rounded_to_float(color_inexact(attributes, c, place, {fragment.x, fragment.y}))
             .contains(to_float(fragment.color[c])))
      return false;
  return true;
}

// True if a primitive under some choices has the fragment's reported values.
using Test = std::function<bool(const PrimitiveAttributes&)>;

bool passes(const ValueContext& context, const Fragment& fragment, const RuleChoices& choices,
            const Test& test) {
  return test(attributes_of(context.primitive_of(fragment), choices, context.scene.target));
}

// True if either axis may be the major one of the fragment's line, and its values follow the
// shorter.
bool goes_by_other_axis(const ValueContext& context, const Fragment& fragment, RuleChoices choices,
                        const Test& test) {
  if (context.primitive_of(fragment).kind != PrimitiveKind::line) return false;
  const PrimitiveValues& values = context.values_of(fragment);
  if (!may_swap_axes(values.lawful.depth, values.reach)) return false;
  choices.values.line_parameter = LineParameter::minor_axis;
  return passes(context, fragment, choices, test);
}

// The change of interpolation under which the test passes; none if there is none. To list the
// changes of a rule takes as long as to try one, so each rule waits for its turn.
Cause first_change(const ValueContext& context, const Fragment& fragment, const Test& test) {
  RuleChoices choices = context.choices;
  choices.values = ValueChoice{};
  for (const RuleId rule : kRules)
    for (const Change& change : changes_beside(rule, choices))
      if (passes(context, fragment, change.applied_to(choices), test) ||
          (is_by_major_axis(change.id) && goes_by_other_axis(context, fragment, choices, test)))
        return change.id;
  return {};
}

}  // namespace

bool is_by_major_axis(const Cause& cause) {
  return cause ==
         Cause(alternative_id(RuleId::attribute_smooth, name_of(LineParameter::major_axis)));
}

Cause cause_of_color(const ValueContext& context, const Fragment& fragment) {
  const auto change_at = [&](Point place) {
    return first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
      return yields_color(attributes, place, fragment);
    });
  };
  const auto place_under = [&](const Change& change) {
    return context.place_of(fragment, locations_of(change, context.choices));
  };
  Cause cause = change_at(context.place_of(fragment, context.choices.values.locations));
  if (!cause.empty()) return cause;
  const Changes elsewhere = changes_beside(kLocationRules, context.choices);
  cause = first_cause(elsewhere, [&](const Change& change) {
    return yields_color(context.values_of(fragment).chosen, place_under(change), fragment);
  });
  if (!cause.empty()) return cause;
  for (const Change& change : elsewhere)
    if (cause = change_at(place_under(change)); !cause.empty()) return cause + change.id;
  return {};
}

namespace {

// For a draw without GL_MULTISAMPLE.
Cause cause_of_depth_if_ignored(const ValueContext& context, const Fragment& fragment) {
  const auto yields = [&](const LocationChoice& locations) {
    const auto place = depth_place_if_ignored(context, fragment, locations);
    const Interpolant& depth = context.values_of(fragment).chosen.depth;
    return place && rounded_to_float(clamped_depth(context.values_of(fragment).chosen,
                                                   interpolate_inexact(depth, *place)))
                        .contains(to_float(fragment.depth));
  };
  const Cause cause = cause_of(MultisampleSwitch::ignored);
  if (yields(context.choices.values.locations)) return cause;
  for (const Change& change : changes_beside(RuleId::sample_depth, context.choices))
    if (yields(locations_of(change, context.choices))) return Cause(change.id) + cause;
  return {};
}

}  // namespace

Cause cause_of_depth(const ValueContext& context, const Fragment& fragment) {
  const LocationChoice& chosen = context.choices.values.locations;
  const Cause cause = first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
    return yields_depth(context, fragment, attributes.depth, chosen);
  });
  if (!cause.empty()) return cause;
  const Interpolant& depth = context.values_of(fragment).chosen.depth;
  for (const Change& change : changes_beside(RuleId::sample_depth, context.choices))
    if (yields_depth(context, fragment, depth, locations_of(change, context.choices)))
      return change.id;
  Cause ignored = cause_of_depth_if_ignored(context, fragment);
  if (!ignored.empty() || !has_offset(context, fragment)) return ignored;
  return cause_of_offset(context, fragment);
}

Cause cause_of_inverse_w(const ValueContext& context, const Fragment& fragment, double inverse_w) {
  const Point place = context.depth_place_of(fragment, context.choices.values.locations);
  return first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
    return rounded_to_float(interpolate_inexact(attributes.inverse_w, place))
        .contains(to_float(inverse_w));
  });
}

Cause cause_of_derivatives(const ValueContext& context, const Fragment& fragment,
                           const FragmentDetail& detail, const std::array<Derivative, 2>& along) {
  const QuadPixel at = quad_place(context, fragment);
  return first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
    return std::ranges::any_of(values_of<DerivativeMethod>(), [&](DerivativeMethod method) {
      return std::ranges::all_of(along, [&](Derivative derivative) {
        const auto& reported = detail.derivatives[static_cast<std::size_t>(derivative)];
        return !reported || yields_derivative(attributes.color, at, derivative, method, *reported);
      });
    });
  });
}

QuadPixel quad_place(const ValueContext& context, const Fragment& fragment) {
  return quad_of({fragment.x, fragment.y}, context.choices.values, context.scene.target);
}

bool yields_derivative(const std::array<Interpolant, 4>& color, const QuadPixel& at,
                       Derivative derivative, DerivativeMethod method,
                       const std::array<double, 4>& rendered) {
  for (std::size_t c = 0; c < 4; ++c) {
    if (!std::isfinite(rendered[c])) return false;
    const Interval range = derivative_inexact(color[c], at, axis_of(derivative), method);
    if (!rounded_to_float(range).contains(to_float(rendered[c]))) return false;
  }
  return true;
}

// --------------------------------------------------------------------------------------- locations

namespace {

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
