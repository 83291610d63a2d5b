// SPDX-License-Identifier: MIT
//
// Colours and depths per fragment (rulings 8 and 9).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "diff/value_diff.h"
#include "raster/rasterizer.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/values/flat_attribute.h"
#include "rules/values/smooth_attribute.h"

namespace edgecase {
namespace {

// Distance between neighbouring float32 values at `value`.
double float_ulp(double value) {
  const float at = std::fabs(static_cast<float>(value));
  return static_cast<double>(std::nextafterf(at, HUGE_VALF)) - static_cast<double>(at);
}

double to_float(double value) {
  return static_cast<double>(static_cast<float>(value));
}

// Correct rounding is monotonic, so the roundings of the interval's ends enclose that of the value.
Interval rounded_to_float(Interval value) {
  return {to_float(value.low), to_float(value.high)};
}

// Where a value is told: the pixel, and for lines the width that the fragment is part of.
struct Place {
  PixelPosition pixel;
  int width = 1;
};

// One component of a told value, with what is exact and what is permitted for it.
struct Component {
  double exact = 0;            // the double nearest to the exact value
  Interval correct;            // float32 values that count as correctly rounded
  Interval permitted;          // float32 values that the specification allows
  bool by_major_axis = false;  // on a line: allowed if t ran along the major axis
  double rendered = 0;

  bool is_correct() const { return correct.contains(to_float(rendered)); }
  bool is_permitted() const { return permitted.contains(to_float(rendered)); }
};

// What is permitted at a sample of a line as wide as `width`, rounded: each fragment of a column
// may have the value of its own centre or of any other of the column (ruling 13).
Interval permitted_across(const Interpolant& interpolant, Point sample, int width, int bits) {
  Interval result = interpolate_permitted(interpolant, sample, bits);
  if (interpolant.kind != PrimitiveKind::line || width == 1) return result;
  const bool x_major = Segment{interpolant.positions[0], interpolant.positions[1]}.x_major();
  const Fixed reach = Fixed::from_integer(width - 1);
  for (const Fixed offset : {reach, -reach}) {
    Point moved = sample;
    (x_major ? moved.y : moved.x) = (x_major ? moved.y : moved.x) + offset;
    result = hull(result, interpolate_permitted(interpolant, moved, bits));
  }
  return result;
}

// `forgiving`: what is correct under the policy is permitted, whatever its formula.
Component make_component(Interpolant interpolant, const Place& place, int bits, double rendered,
                         bool forgiving) {
  const Point sample = pixel_centre(place.pixel.x, place.pixel.y);
  const Interval exact = interpolate_exact(interpolant, sample);
  Component result;
  result.exact = exact.low / 2 + exact.high / 2;
  result.correct = rounded_to_float(exact);
  result.rendered = rendered;
  result.permitted = result.correct;
  const bool lawful = forgiving || interpolant.line_parameter == LineParameter::projection;
  if (result.is_correct() && lawful) return result;
  // The specification's formula, whatever the policy's is.
  interpolant.line_parameter = LineParameter::projection;
  result.permitted = rounded_to_float(permitted_across(interpolant, sample, place.width, bits));
  interpolant.line_parameter = LineParameter::major_axis;
  result.by_major_axis = interpolant.kind == PrimitiveKind::line &&
                         rounded_to_float(interpolate_permitted(interpolant, sample, bits))
                             .contains(to_float(rendered));
  return result;
}

bool shows(const Fragment& fragment, const Color& color) {
  return std::equal(color.begin(), color.end(), fragment.color.begin(),
                    [](float a, double b) { return a == static_cast<float>(b); });
}

// The vertex whose colour a flat fragment shows against the scene's convention, as a cause.
std::string wrong_provoking_vertex(const ScenePrimitive& primitive, const Fragment& fragment) {
  for (const auto& [choice, name] :
       {std::pair{ProvokingChoice::first, "first"}, std::pair{ProvokingChoice::last, "last"}}) {
    if (shows(fragment, primitive.vertices[provoking_index(primitive, choice)]->color))
      return fmt::format("attribute.provoking-vertex={}", name);
  }
  return "";
}

void compare_flat_color(const ValueContext& context, const ScenePrimitive& primitive,
                        const Fragment& fragment, Result& result) {
  const Draw& draw = *primitive.state;
  const Color& color =
      primitive.vertices[provoking_index(primitive, context.choice.provoking)]->color;
  const bool legal = shows(
      fragment, primitive.vertices[provoking_index(primitive, ProvokingChoice::as_set)]->color);
  const bool agrees = shows(fragment, color);
  if (agrees && (legal || context.latitude == Latitude::none)) return;
  Disagreement d =
      value_disagreement({fragment.x, fragment.y}, fragment.primitive, "attribute.flat", 8);
  d.legal = legal;
  d.policy_agrees = agrees;
  d.exact.assign(color.begin(), color.end());
  d.rendered.assign(fragment.color.begin(), fragment.color.end());
  d.cause = wrong_provoking_vertex(primitive, fragment);
  d.explanation = fmt::format(
      "the flat colour of primitive {} is that of its {} vertex, ({:.9g}), copied without "
      "computation; the renderer has ({:.9g}){}",
      fragment.primitive, name_of(draw.provoking_vertex), fmt::join(d.exact, ", "),
      fmt::join(d.rendered, ", "), d.cause.empty() ? "" : ", the colour of another vertex");
  result.disagreements.push_back(std::move(d));
}

Disagreement beyond_disagreement(std::span<const Component> components, const Component& beyond,
                                 const Fragment& fragment, const char* rule) {
  Disagreement d = value_disagreement({fragment.x, fragment.y}, fragment.primitive, rule, 9);
  for (const Component& c : components) {
    d.exact.push_back(c.exact);
    d.rendered.push_back(c.rendered);
  }
  if (std::all_of(components.begin(), components.end(),
                  [](const Component& c) { return c.is_correct() || c.by_major_axis; }))
    d.cause = "attribute.smooth=major-axis";
  d.policy_agrees = std::all_of(components.begin(), components.end(),
                                [](const Component& c) { return c.is_correct(); });
  d.explanation = fmt::format(
      "component {} of primitive {} is exactly {:.9g} at the pixel's centre ({}, {}); the "
      "specification permits {:.9g} to {:.9g}, the renderer has {:.9g}",
      &beyond - components.data(), fragment.primitive, beyond.exact, fragment.x + .5,
      fragment.y + .5, beyond.permitted.low, beyond.permitted.high, beyond.rendered);
  return d;
}

// Components of one attribute of one fragment: agree, permitted (aggregated) or beyond.
void compare_components(std::span<const Component> components, const Fragment& fragment,
                        const char* rule, ValueAggregator& aggregator, Result& result) {
  aggregator.count_compared();
  const auto beyond = std::find_if(components.begin(), components.end(),
                                   [](const Component& c) { return !c.is_permitted(); });
  if (beyond != components.end()) {
    result.disagreements.push_back(beyond_disagreement(components, *beyond, fragment, rule));
    return;
  }
  const ValueAggregate::Place place{fragment.x, fragment.y, fragment.primitive};
  bool differs = false;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Component& c = components[i];
    if (c.is_correct()) continue;
    differs = true;
    aggregator.add_error(place, static_cast<int>(i), {c.exact, c.rendered},
                         std::fabs(c.rendered - c.exact) / float_ulp(c.exact));
  }
  if (differs) aggregator.add_place(place);
}

}  // namespace

void compare_fragment_values(const ValueContext& context, const Rendering& rendered,
                             Result& result) {
  const LineParameter parameter = context.choice.line_parameter;
  const bool forgiving = context.latitude == Latitude::none;
  ValueAggregator colors("color", "attribute.smooth", 9);
  ValueAggregator depths("depth", "fragment.depth", 9);
  for (const Fragment& f : rendered.fragments) {
    const ScenePrimitive& primitive = context.primitives[static_cast<std::size_t>(f.primitive)];
    const Place place{{f.x, f.y}, rounded_width(primitive.state->line_width)};
    if (f.has_color && primitive.state->interpolation == Interpolation::flat) {
      compare_flat_color(context, primitive, f, result);
    } else if (f.has_color) {
      std::array<Component, 4> components;
      for (std::size_t c = 0; c < 4; ++c)
        components[c] = make_component(color_interpolant(primitive, c, parameter), place,
                                       context.bits, f.color[c], forgiving);
      compare_components(components, f, "attribute.smooth", colors, result);
    }
    if (f.has_depth) {
      const Component depth = make_component(depth_interpolant(primitive, parameter), place,
                                             context.bits, f.depth, forgiving);
      compare_components({&depth, 1}, f, "fragment.depth", depths, result);
    }
  }
  colors.flush(result);
  depths.flush(result);
}

}  // namespace edgecase
