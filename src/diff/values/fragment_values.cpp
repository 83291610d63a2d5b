// SPDX-License-Identifier: MIT
//
// Colours, depths and gl_FragCoord per fragment (rulings 8, 9, 13 and 17).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/findings/patience.h"
#include "diff/values/coordinate_places.h"
#include "diff/values/drawn_fragments.h"
#include "diff/values/flat_values.h"
#include "diff/values/followed_location.h"
#include "diff/values/ignored_multisample.h"
#include "diff/values/offset_causes.h"
#include "diff/values/value_causes.h"
#include "diff/values/value_diff.h"
#include "diff/values/value_judge.h"
#include "rules/all_rules.h"
#include "rules/coverage/clip_volume.h"
#include "rules/output/polygon_offset.h"
#include "rules/values/attributes.h"

namespace edgecase {
namespace {

// "the pixel's centre (2.5, 3.5)", "(2.375, 3.125)".
std::string describe_location(Point place) {
  const Point centre = pixel_centre(place.x.floor(), place.y.floor());
  return (place == centre ? "the pixel's centre " : "") + format_point(place);
}

// What people call a component: "red", "texture coordinate s", "depth".
std::string name_of_component(const std::string& attribute, std::size_t component) {
  constexpr std::array kColor{"red", "green", "blue", "alpha"};
  constexpr std::array kCoordinates{"texture coordinate s", "texture coordinate t"};
  if (attribute == "color") return kColor.at(component);
  if (attribute == "texture coordinates") return kCoordinates.at(component);
  return attribute;
}

Disagreement beyond_disagreement(std::span<const ValueComponent> components,
                                 const ValueComponent& beyond, const Fragment& fragment,
                                 Point place, RuleId rule, const std::string& attribute) {
  Disagreement d = value_disagreement({fragment.x, fragment.y}, fragment.primitive, rule,
                                      kRulingOnInterpolation);
  for (const ValueComponent& c : components) {
    d.exact.push_back(c.exact);
    d.rendered.push_back(c.rendered);
  }
  d.policy_agrees = std::all_of(components.begin(), components.end(),
                                [](const ValueComponent& c) { return c.is_correct(); });
  const auto are_all = [&](bool ValueComponent::*excuse) {
    return std::ranges::all_of(
        components, [&](const ValueComponent& c) { return c.is_permitted() || c.*excuse; });
  };
  if (are_all(&ValueComponent::may_be_of_column)) d.ruling = kRulingOnLineValues;
  if (are_all(&ValueComponent::may_be_mean)) d.ruling = kRulingOnPolygonValues;
  d.explanation = fmt::format(
      "{} of primitive {} is exactly {:.9g} at {}; the specification permits {:.9g} to {:.9g}, the "
      "renderer has {:.9g}",
      name_of_component(attribute, static_cast<std::size_t>(&beyond - components.data())),
      fragment.primitive, beyond.exact, describe_location(place), beyond.permitted.low,
      beyond.permitted.high, beyond.rendered);
  return d;
}

// Compares the components of one attribute of one fragment: they agree, are permitted (aggregated)
// or beyond. Returns the disagreement, which is yet to be added, if there is one.
std::optional<Disagreement> compare_components(std::span<const ValueComponent> components,
                                               const Fragment& fragment, Point place, RuleId rule,
                                               ValueAggregator& aggregator) {
  aggregator.count_compared(components.size());
  const auto beyond = std::find_if(components.begin(), components.end(),
                                   [](const ValueComponent& c) { return !c.is_permitted(); });
  if (beyond != components.end())
    return beyond_disagreement(components, *beyond, fragment, place, rule, aggregator.attribute());
  const ValueAggregate::Place where{fragment.x, fragment.y, fragment.primitive};
  bool differs = false;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const ValueComponent& c = components[i];
    if (c.is_correct()) continue;
    differs = true;
    aggregator.add_error(where, {static_cast<int>(i), c.exact, c.rendered,
                                 error_in_ulp(c.exact, c.rendered), c.range});
  }
  if (differs) aggregator.add_place(where);
  return std::nullopt;
}

// The location where a value is evaluated is a rule of its own.
void blame(const ValueContext& context, const Fragment& fragment, Disagreement& d,
           const Cause& cause) {
  d.cause = cause;
  if (is_by_major_axis(cause)) {
    d.ruling = kRulingOnLineValues;
    d.legality = by_letter(may_go_by_major_axis(context, fragment));
  }
  const RuleId rule = cause.rule();
  if (rule == RuleId::attribute_location || rule == RuleId::attribute_centroid) put_under(rule, d);
}

// True if the depth would be right if it were clamped. That it is not clamped is contested (ruling
// 45).
bool is_unclamped_alone(const ValueContext& context, const Fragment& fragment) {
  const PrimitiveValues& values = context.values_of(fragment);
  const Point place = context.depth_place_of(fragment, context.choices.values.locations);
  const double depth = fragment.depth;
  return std::isfinite(depth) && (depth < 0 || depth > 1) &&
         rounded_to_float(PermittedPlace(values.moved(), place).value(values.permitted_depth))
             .contains(depth);
}

// True for a depth that a mean of a polygon's vertices can have, though not one on its plane.
bool is_mean_of_polygon(const ValueContext& context, const Fragment& fragment, double depth) {
  const PrimitiveValues& values = context.values_of(fragment);
  const double exact = middle(depth_exact(values.lawful, pixel_centre(fragment.x, fragment.y)));
  return values.is_polygon &&
         rounded_to_float(
             clamped_depth(values.lawful, with_means(exact, context.primitive_of(fragment), values,
                                                     values.lawful.depth)))
             .contains(to_float(depth));
}

void contest_place(Disagreement& d) {
  std::tie(d.rule, d.ruling) = std::pair(RuleId::fragment_coordinates, kRulingOnCoordinatePlaces);
}

// Polygon offset is a rule of its own, too.
void blame_depth(const ValueContext& context, const Fragment& fragment, Disagreement& d) {
  if (has_offset(context, fragment) && is_unclamped_alone(context, fragment)) {
    std::tie(d.rule, d.ruling) = std::pair(offset_rule(context, fragment), kRulingOnUnclampedDepth);
    return;
  }
  // A depth with an offset is no mean.
  if (!has_offset(context, fragment) && is_mean_of_polygon(context, fragment, fragment.depth)) {
    d.ruling = kRulingOnPolygonDepth;
    return;
  }
  blame(context, fragment, d, cause_of_depth(context, fragment));
  if (!has_offset(context, fragment)) return;
  if (d.cause.empty())
    put_under(offset_rule(context, fragment), d);
  else if (const RuleId rule = d.cause.rule(); rule == RuleId::offset_slope ||
                                               rule == RuleId::offset_unit ||
                                               rule == RuleId::offset_exponent)
    put_under(rule, d);
}

// The fragment with the interpolated values in the colour's place.
Fragment interpolated(const ValueContext& context, const Rendering& rendered, Fragment fragment) {
  if (!context.primitive_of(fragment).state->texture) return fragment;
  const FragmentDetail* detail =
      fragment.detail < 0 ? nullptr : &rendered.details[static_cast<std::size_t>(fragment.detail)];
  fragment.has_color = detail != nullptr && detail->texture_coordinates;
  if (fragment.has_color)
    fragment.color = {(*detail->texture_coordinates)[0], (*detail->texture_coordinates)[1], 0, 1};
  return fragment;
}

// The fragment as exact drew it, with the interpolated values in the colour's place; none if exact
// has no such fragment.
std::optional<Fragment> interpolated_by_exact(const ValueContext& context, const Rendering& exact,
                                              DrawnFragments& drawn, const Fragment& fragment) {
  const Fragment* const found = drawn.find(fragment);
  if (found == nullptr) return std::nullopt;
  return interpolated(context, exact, *found);
}

// True if both fragments of the primitive report the same values.
bool report_the_same(const Fragment& a, const Fragment& b) {
  return a.primitive == b.primitive && a.has_color == b.has_color && a.has_depth == b.has_depth &&
         a.color == b.color && a.depth == b.depth;
}

}  // namespace

void compare_fragment_values(const ValueContext& context, const Rendering& exact,
                             const Rendering& rendered, Result& result) {
  ValueAggregator colors("color", RuleId::attribute_smooth);
  const FollowedLocation followed = followed_location(context, rendered);
  ValueAggregator elsewhere("color", followed.rule, followed.ruling, followed.cause);
  ValueAggregator coordinates("texture coordinates", RuleId::attribute_smooth);
  ValueAggregator depths("depth", RuleId::fragment_depth, kRulingOnInterpolation);
  const FollowedDepth followed_z = followed_depth(context, rendered);
  ValueAggregator depths_elsewhere("depth", followed_z.rule, followed_z.ruling, followed_z.cause);
  const FollowedOffset followed_o = followed_offset(context, rendered);
  ValueAggregator depths_offset("depth", followed_o.rule, followed_o.ruling, followed_o.cause);
  // The latest fragment of each primitive, if it is correct and represents all that report the same
  // values, and the aggregators that counted its values.
  struct Correct {
    const Fragment* fragment = nullptr;
    ValueAggregator* color = nullptr;
    ValueAggregator* depth = nullptr;
  };
  std::vector<Correct> correct_ones(context.primitives.size());
  DrawnFragments drawn(exact);
  for (const Fragment& reported : rendered.fragments) {
    Patience::check();
    Correct& correct = correct_ones[static_cast<std::size_t>(reported.primitive)];
    if (correct.fragment != nullptr && report_the_same(*correct.fragment, reported)) {
      if (correct.color != nullptr) correct.color->count_compared(reported.color.size());
      if (correct.depth != nullptr) correct.depth->count_compared(1);
      continue;
    }
    const Draw& draw = *context.primitive_of(reported).state;
    const Fragment f = interpolated(context, rendered, reported);
    const bool textured = draw.texture.has_value();
    const ValueJudge judge(context, f, interpolated_by_exact(context, exact, drawn, f));
    bool is_correct = !textured && judge.asks_alike_everywhere();
    correct = {};
    if (f.has_color && draw.interpolation == Interpolation::flat) {
      is_correct = compare_flat_color(context, f, result) && is_correct;
    } else if (f.has_color) {
      std::array<ValueComponent, 4> of_color;
      const std::span components = std::span(of_color).first(textured ? 2 : 4);
      for (std::size_t c = 0; c < components.size(); ++c)
        components[c] = judge.color(c, f.color[c]);
      is_correct = is_correct && std::ranges::all_of(components, &ValueComponent::is_correct);
      correct.color = textured                        ? &coordinates
                      : followed.explains(context, f) ? &elsewhere
                                                      : &colors;
      auto d = compare_components(components, f, judge.place(), RuleId::attribute_smooth,
                                  *correct.color);
      if (d) {
        blame(context, f, *d, cause_of_color(context, f));
        add_disagreement(result, *std::move(d));
        is_correct = false;
      }
    }
    if (f.has_depth) {
      const ValueComponent depth = judge.depth(f.depth);
      is_correct = is_correct && depth.is_correct();
      correct.depth = followed_z.explains(context, f)   ? &depths_elsewhere
                      : followed_o.explains(context, f) ? &depths_offset
                                                        : &depths;
      auto d = compare_components({&depth, 1}, f, judge.depth_place(), RuleId::fragment_depth,
                                  *correct.depth);
      if (d) {
        const auto elsewhere_in_pixel = other_place(context, rendered, f);
        if (elsewhere_in_pixel && has_depth_of(context, f, *elsewhere_in_pixel))
          contest_place(*d);
        else
          blame_depth(context, f, *d);
        add_disagreement(result, *std::move(d));
        is_correct = false;
      }
    }
    if (is_correct) correct.fragment = &reported;
  }
  colors.flush(result);
  elsewhere.flush(result);
  coordinates.flush(result);
  depths.flush(result);
  depths_elsewhere.flush(result);
  depths_offset.flush(result);
}

namespace {

// gl_FragCoord.xy elsewhere in the pixel than exact has it.
void add_coordinates(ValueAggregator& aggregator, const Fragment& f, Point exact,
                     const std::array<double, 2>& rendered) {
  const std::array<double, 2> at{exact.x.to_double(), exact.y.to_double()};
  const ValueAggregate::Place place{f.x, f.y, f.primitive};
  for (std::size_t i = 0; i < at.size(); ++i)
    if (rendered[i] != at[i])
      aggregator.add_error(
          place, {static_cast<int>(i), at[i], rendered[i], error_in_ulp(at[i], rendered[i]), 1});
  aggregator.add_place(place);
}

}  // namespace

void compare_coordinates(const ValueContext& context, const Rendering& exact,
                         const Rendering& rendered, Result& result) {
  constexpr RuleId kRule = RuleId::fragment_coordinates;
  const FollowedDepth followed = followed_depth(context, rendered);
  ValueAggregator depths("gl_FragCoord.z", kRule);
  ValueAggregator elsewhere("gl_FragCoord.z", followed.rule, followed.ruling, followed.cause);
  ValueAggregator inverses("gl_FragCoord.w", kRule);
  ValueAggregator places("gl_FragCoord.xy", kRule);
  DrawnFragments drawn(exact);
  for (const Fragment& f : rendered.fragments) {
    Patience::check();
    if (f.detail < 0) continue;
    const FragmentDetail& detail = rendered.details[static_cast<std::size_t>(f.detail)];
    if (!detail.coordinates) continue;
    const auto& [x, y, z, w] = *detail.coordinates;
    const Point place = context.coordinates_of(f);
    const bool is_exact = x == place.x.to_double() && y == place.y.to_double();
    const bool anywhere = !context.permitted_coordinates(f).empty();
    const bool inside = x >= f.x && x <= f.x + 1 && y >= f.y && y <= f.y + 1;
    const std::optional<Point> other = other_place(context, rendered, f);
    if (!is_exact && anywhere && inside && !other) {
      add_coordinates(places, f, place, {x, y});
    } else if (!is_exact) {
      Disagreement d = value_disagreement({f.x, f.y}, f.primitive, kRule);
      d.exact = {place.x.to_double(), place.y.to_double()};
      d.rendered = {x, y};
      d.explanation = fmt::format("gl_FragCoord.xy is ({:.9g}, {:.9g}), not {}", x, y,
                                  describe_location(place));
      const auto ignored = coordinates_if_ignored(context, f);
      if (ignored && x == ignored->x.to_double() && y == ignored->y.to_double())
        d.cause = cause_of(MultisampleSwitch::ignored);
      if (other) contest_place(d);
      add_disagreement(result, std::move(d));
    }
    const ValueJudge judge(context, f, interpolated_by_exact(context, exact, drawn, f));
    const ValueComponent depth = judge.depth(z);
    const ValueComponent inverse = judge.inverse_w(w);
    Fragment reported = f;
    reported.depth = z;
    auto d = compare_components({&depth, 1}, f, judge.depth_place(), kRule,
                                followed.explains(context, reported) ? elsewhere : depths);
    if (d) {
      if (other && has_depth_of(context, reported, *other))
        contest_place(*d);
      else
        blame_depth(context, reported, *d);
      add_disagreement(result, *std::move(d));
    }
    d = compare_components({&inverse, 1}, f, judge.depth_place(), kRule, inverses);
    if (d) {
      if (is_at_share_of_one(context, f) && has_w_of_pixel(context, f, w))
        contest_place(*d);
      else
        blame(context, f, *d, cause_of_inverse_w(context, f, w));
      add_disagreement(result, *std::move(d));
    }
  }
  depths.flush(result);
  elsewhere.flush(result);
  inverses.flush(result);
  places.flush(result);
}

}  // namespace edgecase
