// SPDX-License-Identifier: MIT
#include "diff/values/value_causes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "diff/values/ignored_multisample.h"
#include "diff/values/offset_causes.h"
#include "rules/all_rules.h"
#include "rules/change_search.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

constexpr RuleId kRules[] = {RuleId::attribute_smooth, RuleId::attribute_perspective,
                             RuleId::attribute_positions};

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

LocationChoice locations_of(const Change& change, const RuleChoices& chosen) {
  return change.applied_to(chosen).values.locations;
}

bool yields_color(const PrimitiveAttributes& attributes, Point place, const Fragment& fragment) {
  for (std::size_t c = 0; c < 4; ++c)
    if (!rounded_to_float(color_inexact(attributes, c, place, {fragment.x, fragment.y}))
             .contains(to_float(fragment.color[c])))
      return false;
  return true;
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

}  // namespace edgecase
