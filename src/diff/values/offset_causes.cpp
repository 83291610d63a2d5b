// SPDX-License-Identifier: MIT
#include "diff/values/offset_causes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "diff/coverage/vertex_latitude.h"
#include "diff/findings/most_meet.h"
#include "rules/all_rules.h"
#include "rules/change_search.h"
#include "rules/choices.h"
#include "rules/output/polygon_offset.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

RuleId unit_rule(DepthFormat format) {
  return holds_floats(format) ? RuleId::offset_exponent : RuleId::offset_unit;
}

// Every alternative besides the chosen ones, units first, then every slope with every unit.
std::vector<Changes> offset_changes(const RuleChoices& chosen, DepthFormat format) {
  const Changes slopes = changes_beside(RuleId::offset_slope, chosen);
  const Changes units = changes_beside(unit_rule(format), chosen);
  std::vector<Changes> sets = singles_of({units, slopes});
  for (Changes& pair : pairs_of({slopes, units})) sets.push_back(std::move(pair));
  return sets;
}

PrimitiveAttributes attributes_under(const ValueContext& context, const Fragment& fragment,
                                     const Changes& changes) {
  return attributes_of(context.primitive_of(fragment), applied(changes, context.choices),
                       context.scene.target);
}

Point plain_place_of(const ValueContext& context, const Fragment& fragment) {
  return context.depth_place_of(fragment, context.choices.values.locations);
}

bool is_exact(const ValueContext& context, const Fragment& fragment,
              const PrimitiveAttributes& attributes) {
  return to_float(middle(depth_exact(attributes, plain_place_of(context, fragment)))) ==
         to_float(fragment.depth);
}

bool is_inexact(const ValueContext& context, const Fragment& fragment,
                const PrimitiveAttributes& attributes) {
  const Interval depth = interpolate_inexact(attributes.depth, plain_place_of(context, fragment));
  return rounded_to_float(clamped_depth(attributes, depth)).contains(to_float(fragment.depth));
}

using Test = bool (*)(const ValueContext&, const Fragment&, const PrimitiveAttributes&);

// True if all fragments with an offset pass the test under these changes.
bool all_pass(const ValueContext& context, const Rendering& rendered, const Changes& changes,
              Test test) {
  std::map<int, PrimitiveAttributes> attributes;
  return std::ranges::all_of(rendered.fragments, [&](const Fragment& fragment) {
    if (!fragment.has_depth || !has_offset(context, fragment)) return true;
    auto known = attributes.find(fragment.primitive);
    if (known == attributes.end())
      known = attributes.emplace(fragment.primitive, attributes_under(context, fragment, changes))
                  .first;
    return test(context, fragment, known->second);
  });
}

}  // namespace

bool has_offset(const ValueContext& context, const Fragment& fragment) {
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  return primitive.kind == PrimitiveKind::triangle && primitive.state->polygon_offset;
}

RuleId offset_rule(const ValueContext& context, const Fragment& fragment) {
  if (context.primitive_of(fragment).state->polygon_offset->factor != 0)
    return RuleId::offset_slope;
  return unit_rule(context.scene.target.depth);
}

Cause cause_of_offset(const ValueContext& context, const Fragment& fragment) {
  const auto sets = offset_changes(context.choices, context.scene.target.depth);
  return first_cause(sets, [&](const Changes& changes) {
    return is_inexact(context, fragment, attributes_under(context, fragment, changes));
  });
}

FollowedOffset followed_offset(const ValueContext& context, const Rendering& rendered) {
  // Most scenes have no polygon offset; then no fragment is tested.
  if (std::ranges::none_of(context.scene.draws,
                           [](const Draw& draw) { return draw.polygon_offset.has_value(); }))
    return {};
  const auto concerned = [&](const Fragment& f) { return f.has_depth && has_offset(context, f); };
  if (std::ranges::none_of(rendered.fragments, concerned)) return {};
  // The alternative that yields every depth to the bit, else one with inexact operations.
  for (const Test test : {&is_exact, &is_inexact}) {
    if (all_pass(context, rendered, {}, test)) return {};
    const auto sets = offset_changes(context.choices, context.scene.target.depth);
    const Cause cause = first_cause(
        sets, [&](const Changes& changes) { return all_pass(context, rendered, changes, test); });
    if (!cause.empty()) return {cause, cause.rule(), rule_of(cause.rule()).ruling};
  }
  return {};
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The part that depends on the primitive alone.
struct OffsetPrimitive {
  Interpolant depth;  // before any offset
  MovedVertices vertices;
  PolygonOffset offset;
  Interval slope;  // factor m
};

OffsetPrimitive offset_primitive(const ValueContext& context, const ScenePrimitive& primitive) {
  const Target& target = context.scene.target;
  const double reach = reach_of(primitive, context.bits()).to_double();
  const Interpolant depth =
      depth_without_offset(primitive, lawful_choices(context.choices), target);
  const PolygonOffset& offset = *primitive.state->polygon_offset;
  return {depth, MovedVertices(depth, reach), offset,
          offset_permitted({offset.factor, 0, 0}, depth, target.depth, reach, 0)};
}

// True if all vertices have one depth, which is the fragments' before any offset: they carry a mean
// of the vertices' (14.6.1).
bool is_level(const OffsetPrimitive& primitive) {
  const auto& z = primitive.depth.values;
  return z[0].low == z[0].high && z[1].low == z[0].low && z[1].high == z[0].low &&
         z[2].low == z[0].low && z[2].high == z[0].low;
}

// factor m + units r: the reported depth, to within an error, less that of the primitive. Clamped
// depths and offsets may have been anything farther out.
Interval sum_of_offset(const OffsetPrimitive& primitive, Interval depth, double reported,
                       double error) {
  Interval sum = Interval(reported - error, reported + error) - depth;
  const auto clamp = static_cast<double>(primitive.offset.clamp);
  if (reported <= 0 || (clamp < 0 && sum.low <= clamp)) sum.low = -kInfinity;
  if (reported >= 1 || (clamp > 0 && sum.high >= clamp)) sum.high = kInfinity;
  return sum;
}

// The units that lead to such a sum; possibly none of them is permitted.
Interval units_of(const OffsetPrimitive& primitive, Interval sum) {
  constexpr double kErrors = 3e-5;  // of both products and of their sum
  const Interval of_units = widened(sum - primitive.slope, kErrors);
  const auto units = static_cast<double>(primitive.offset.units);
  const Interval unit = units > 0 ? Interval(of_units.low / units, of_units.high / units)
                                  : Interval(of_units.high / units, of_units.low / units);
  return std::isnan(unit.low) || std::isnan(unit.high) ? Interval::everything() : unit;
}

std::optional<Interval> common_part(Interval a, Interval b) {
  const Interval both{std::max(a.low, b.low), std::min(a.high, b.high)};
  return both.low <= both.high ? std::optional(both) : std::nullopt;
}

// What the fragments of one primitive show of the unit.
struct ShownUnit {
  OffsetPrimitive primitive;
  std::optional<Interval> unit;  // nothing: they contradict each other
};

bool has_units(const Draw& draw) {
  return draw.polygon_offset && draw.polygon_offset->units != 0;
}

}  // namespace

FollowedUnit followed_fixed_unit(const ValueContext& context, const Rendering& rendered) {
  const DepthFormat format = context.scene.target.depth;
  const Interval permitted = permitted_fixed_unit(format);
  FollowedUnit followed{permitted, {}};
  if (bits_of(format) == 0 || std::ranges::none_of(context.scene.draws, has_units)) return followed;
  const Interval possible{permitted.low * (1 - 1e-5), permitted.high};
  std::map<int, ShownUnit> primitives;
  std::vector<Weighed> all;
  for (const Fragment& f : rendered.fragments) {
    const ScenePrimitive& primitive = context.primitive_of(f);
    if (!f.has_depth || !std::isfinite(f.depth) || !has_offset(context, f) ||
        !has_units(*primitive.state))
      continue;
    auto at = primitives.find(f.primitive);
    if (at == primitives.end())
      at =
          primitives.emplace(f.primitive, ShownUnit{offset_primitive(context, primitive), possible})
              .first;
    auto& [of, shown] = at->second;
    // If the location is not reported and may be anywhere in the pixel, a slanted depth says
    // nothing of r.
    if (!is_level(of) && !context.permitted_coordinates(f).empty()) continue;
    const Point place = context.depth_place_of(f, context.choices.values.locations);
    const Interval loose =
        units_of(of, sum_of_offset(of, PermittedPlace(of.vertices, place).value(of.depth), f.depth,
                                   float_ulp(f.depth)));
    if (const auto within = common_part(loose, possible)) all.push_back({*within});
    Interval unit = loose;
    if (is_level(of)) {
      const double step =
          is_depth_of(f.depth, format) ? 1 / (std::ldexp(1.0, bits_of(format)) - 1) : 0;
      unit = units_of(
          of, sum_of_offset(of, of.depth.values[0], f.depth,
                            std::max(8 * float_ulp(1.0) * of.depth.values[0].magnitude(), step)));
    }
    if (shown) shown = common_part(*shown, unit);
  }
  followed.unit = where_most_meet(all).value_or(permitted);
  for (const auto& [index, one] : primitives)
    if (one.unit && (one.unit->low > permitted.low || one.unit->high < permitted.high))
      followed.shown.push_back(*one.unit);
  return followed;
}

}  // namespace edgecase
