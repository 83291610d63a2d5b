// SPDX-License-Identifier: MIT
#include "diff/value_causes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

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
      {"attribute.positions=snapped",
       [](ValueChoice& c) { c.positions = AttributePositions::snapped; }}};
  return changes;
}

bool yields(const Interpolant& interpolant, const Fragment& fragment, double rendered) {
  return rounded_to_float(interpolate_inexact(interpolant, pixel_centre(fragment.x, fragment.y)))
      .contains(to_float(rendered));
}

// Does a primitive have, under these choices, what the fragment was told to have?
using Test = std::function<bool(const PrimitiveAttributes&)>;

std::string first_change(const ValueContext& context, const Fragment& fragment, const Test& test) {
  for (const ValueChange& change : all_changes()) {
    RuleChoices choices = context.choices;
    choices.values = ValueChoice{};
    change.apply(choices.values);
    if (test(attributes_of(context.primitive_of(fragment), choices, context.scene.target)))
      return change.cause;
  }
  return "";
}

}  // namespace

std::string cause_of_color(const ValueContext& context, const Fragment& fragment) {
  return first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
    for (std::size_t c = 0; c < 4; ++c)
      if (!yields(attributes.color[c], fragment, fragment.color[c])) return false;
    return true;
  });
}

std::string cause_of_depth(const ValueContext& context, const Fragment& fragment) {
  return first_change(context, fragment, [&](const PrimitiveAttributes& attributes) {
    return yields(attributes.depth, fragment, fragment.depth);
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
