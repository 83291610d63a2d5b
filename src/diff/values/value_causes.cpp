// SPDX-License-Identifier: MIT
#include "diff/values/value_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "diff/samples/switched_off.h"
#include "diff/values/location_causes.h"
#include "diff/values/offset_causes.h"

namespace edgecase {
namespace {

struct ValueChange {
  const char* cause;
  std::function<void(ValueChoice&)> apply;
};

const std::vector<ValueChange>& all_changes() {
  static const std::vector<ValueChange> changes = {
      {"attribute.smooth=major-axis",
       [](ValueChoice& c) { c.line_parameter = LineParameter::major_axis; }},
      {"attribute.perspective=always",
       [](ValueChoice& c) { c.perspective = PerspectiveChoice::always; }},
      {"attribute.perspective=never",
       [](ValueChoice& c) { c.perspective = PerspectiveChoice::never; }},
      {"attribute.perspective=w-of-centre",
       [](ValueChoice& c) { c.perspective = PerspectiveChoice::w_of_centre; }},
      {"attribute.positions=snapped",
       [](ValueChoice& c) { c.positions = AttributePositions::snapped; }}};
  return changes;
}

bool yields_color(const PrimitiveAttributes& attributes, Point place, const Fragment& fragment) {
  for (std::size_t c = 0; c < 4; ++c)
    if (!rounded_to_float(color_inexact(attributes, c, place, {fragment.x, fragment.y}))
             .contains(to_float(fragment.color[c])))
      return false;
  return true;
}

// Does a primitive have, under these choices, what the fragment was told to have?
using Test = std::function<bool(const PrimitiveAttributes&)>;

bool passes(const ValueContext& context, const Fragment& fragment, const ValueChoice& values,
            const Test& test) {
  RuleChoices choices = context.choices;
  choices.values = values;
  return test(attributes_of(context.primitive_of(fragment), choices, context.scene.target));
}

// Is the fragment's line one of which either axis may be the major one, and do its values go by the
// shorter?
bool goes_by_other_axis(const ValueContext& context, const Fragment& fragment, const Test& test) {
  if (context.primitive_of(fragment).kind != PrimitiveKind::line) return false;
  const PrimitiveValues& values = context.values_of(fragment);
  if (!may_swap_axes(values.lawful.depth, values.reach)) return false;
  ValueChoice by_minor;
  by_minor.line_parameter = LineParameter::minor_axis;
  return passes(context, fragment, by_minor, test);
}

// The change of how attributes are interpolated under which the test passes; empty: there is none.
std::string first_change(const ValueContext& context, const Fragment& fragment, const Test& test) {
  for (const ValueChange& change : all_changes()) {
    ValueChoice values;
    change.apply(values);
    if (passes(context, fragment, values, test)) return change.cause;
    if (is_by_major_axis(change.cause) && goes_by_other_axis(context, fragment, test))
      return change.cause;
  }
  return "";
}

}  // namespace

std::string cause_of_color(const ValueContext& context, const Fragment& fragment) {
  const LocationChoice& chosen = context.choices.values.locations;
  const Point place = context.place_of(fragment, chosen);
  const std::string cause =
      first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
        return yields_color(attributes, place, fragment);
      });
  if (!cause.empty()) return cause;
  for (const LocationChange& change : locations_beside(chosen))
    if (yields_color(context.values_of(fragment).chosen, context.place_of(fragment, change.choice),
                     fragment))
      return change.cause;
  for (const LocationChange& change : locations_beside(chosen)) {
    const Point elsewhere = context.place_of(fragment, change.choice);
    const std::string other =
        first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
          return yields_color(attributes, elsewhere, fragment);
        });
    if (!other.empty()) return fmt::format("{} + {}", other, change.cause);
  }
  return "";
}

namespace {

// Of a draw without GL_MULTISAMPLE.
std::string cause_of_depth_if_ignored(const ValueContext& context, const Fragment& fragment) {
  const auto yields = [&](const LocationChoice& locations) {
    const auto place = depth_place_if_ignored(context, fragment, locations);
    const Interpolant& depth = context.values_of(fragment).chosen.depth;
    return place && rounded_to_float(clamped_depth(context.values_of(fragment).chosen,
                                                   interpolate_inexact(depth, *place)))
                        .contains(to_float(fragment.depth));
  };
  const std::string cause = cause_of(MultisampleSwitch::ignored);
  const LocationChoice& chosen = context.choices.values.locations;
  if (yields(chosen)) return cause;
  for (const LocationChange& change : depth_locations_beside(chosen))
    if (yields(change.choice)) return fmt::format("{} + {}", change.cause, cause);
  return "";
}

}  // namespace

std::string cause_of_depth(const ValueContext& context, const Fragment& fragment) {
  const LocationChoice& chosen = context.choices.values.locations;
  const std::string cause =
      first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
        return yields_depth(context, fragment, attributes.depth, chosen);
      });
  if (!cause.empty()) return cause;
  const Interpolant& depth = context.values_of(fragment).chosen.depth;
  for (const LocationChange& change : depth_locations_beside(chosen))
    if (yields_depth(context, fragment, depth, change.choice)) return change.cause;
  std::string ignored = cause_of_depth_if_ignored(context, fragment);
  if (!ignored.empty() || !has_offset(context, fragment)) return ignored;
  return cause_of_offset(context, fragment);
}

std::string cause_of_inverse_w(const ValueContext& context, const Fragment& fragment,
                               double inverse_w) {
  const Point place = context.depth_place_of(fragment, context.choices.values.locations);
  return first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
    return rounded_to_float(interpolate_inexact(attributes.inverse_w, place))
        .contains(to_float(inverse_w));
  });
}

std::string cause_of_derivatives(const ValueContext& context, const Fragment& fragment,
                                 const FragmentDetail& detail,
                                 const std::array<Derivative, 2>& along) {
  const QuadPixel at = quad_place(context, fragment);
  return first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
    return std::ranges::any_of(all_derivative_methods(), [&](DerivativeMethod method) {
      return std::ranges::all_of(along, [&](Derivative derivative) {
        const auto kind = static_cast<std::size_t>(derivative);
        return !detail.has_derivative[kind] || yields_derivative(attributes.color, at, derivative,
                                                                 method, detail.derivatives[kind]);
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
