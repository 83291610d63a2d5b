// SPDX-License-Identifier: MIT
#include "diff/values/value_causes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "diff/coverage/vertex_latitude.h"
#include "diff/values/value_diff.h"
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

// ----------------------------------------------------------------------------- the unit of offsets
//
// The unit of polygon offsets in a fixed-point depth buffer (ruling 38) is one constant, which the
// implementation does not report. Each fragment with a reported depth leaves an interval of units
// that may have led to it; the unit is assumed to lie where most of these intervals meet. If they
// do not all meet, the fragments of the others are the faulty ones.

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

// factor m + units r of a fragment: its depth less that of the primitive. Clamped depths and
// offsets may have been anything farther out.
Interval sum_of_offset(const OffsetPrimitive& primitive, Point place, double reported) {
  const Interval depth = PermittedPlace(primitive.vertices, place).value(primitive.depth);
  Interval sum = Interval(reported - float_ulp(reported), reported + float_ulp(reported)) - depth;
  const auto clamp = static_cast<double>(primitive.offset.clamp);
  if (reported <= 0 || (clamp < 0 && sum.low <= clamp)) sum.low = -kInfinity;
  if (reported >= 1 || (clamp > 0 && sum.high >= clamp)) sum.high = kInfinity;
  return sum;
}

// The units that lead to the fragment's depth; possibly none of them is permitted.
Interval units_of(const OffsetPrimitive& primitive, Point place, double reported) {
  constexpr double kErrors = 3e-5;  // of both products and of their sum
  const Interval of_units =
      widened(sum_of_offset(primitive, place, reported) - primitive.slope, kErrors);
  const auto units = static_cast<double>(primitive.offset.units);
  const Interval unit = units > 0 ? Interval(of_units.low / units, of_units.high / units)
                                  : Interval(of_units.high / units, of_units.low / units);
  return std::isnan(unit.low) || std::isnan(unit.high) ? Interval::everything() : unit;
}

// The interval where most of the intervals meet; `whole` if there are none.
Interval where_most_meet(const std::vector<Interval>& units, Interval whole) {
  std::vector<std::pair<double, int>> ends;  // at the same number, ends come after beginnings
  for (const Interval unit : units) {
    ends.emplace_back(unit.low, 0);
    ends.emplace_back(unit.high, 1);
  }
  std::ranges::sort(ends);
  Interval best = whole;
  int open = 0;
  int most = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    open += ends[i].second == 0 ? 1 : -1;
    if (open <= most) continue;
    most = open;
    best = {ends[i].first, ends[i + 1].first};
  }
  return best;
}

}  // namespace

Interval followed_fixed_unit(const ValueContext& context, const Rendering& rendered) {
  const DepthFormat format = context.scene.target.depth;
  const Interval permitted = permitted_fixed_unit(format);
  const auto has_units = [](const Draw& draw) {
    return draw.polygon_offset && draw.polygon_offset->units != 0;
  };
  if (bits_of(format) == 0 || std::ranges::none_of(context.scene.draws, has_units))
    return permitted;
  std::vector<std::optional<OffsetPrimitive>> primitives(context.primitives.size());
  std::vector<Interval> all;
  for (const Fragment& f : rendered.fragments) {
    const ScenePrimitive& primitive = context.primitive_of(f);
    if (!f.has_depth || !std::isfinite(f.depth) || !has_offset(context, f) ||
        !has_units(*primitive.state))
      continue;
    // If the location is not reported and may be anywhere in the pixel, the depth says nothing of
    // r.
    if (!context.permitted_coordinates(f).empty()) continue;
    auto& known = primitives[static_cast<std::size_t>(f.primitive)];
    if (!known) known.emplace(offset_primitive(context, primitive));
    const Point place = context.depth_place_of(f, context.choices.values.locations);
    const Interval unit = units_of(*known, place, f.depth);
    const Interval within{std::max(unit.low, permitted.low * (1 - 1e-5)),
                          std::min(unit.high, permitted.high)};
    if (within.low <= within.high) all.push_back(within);
  }
  return where_most_meet(all, permitted);
}

}  // namespace edgecase
