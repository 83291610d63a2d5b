// SPDX-License-Identifier: MIT
//
// The unit of polygon offsets in a fixed-point depth buffer (ruling 38): one constant, which the
// implementation does not tell. Each fragment whose depth is told leaves an interval of units that
// may have led to it; the unit is taken to be where most of these intervals meet. Where they do not
// all meet, the fragments of the others are the odd ones out.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "diff/values/offset_causes.h"
#include "diff/values/value_diff.h"
#include "diff/values/vertex_latitude.h"
#include "rules/output/polygon_offset.h"
#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What depends on the primitive alone.
struct OffsetPrimitive {
  Interpolant depth;  // before anything is added
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

// factor m + units r of a fragment: what its depth has more than the primitive's. Clamped depths
// and offsets may have been anything further.
Interval sum_of_offset(const OffsetPrimitive& primitive, Point place, double told) {
  const Interval depth = PermittedPlace(primitive.vertices, place).value(primitive.depth);
  Interval sum = Interval(told - float_ulp(told), told + float_ulp(told)) - depth;
  const auto clamp = static_cast<double>(primitive.offset.clamp);
  if (told <= 0 || (clamp < 0 && sum.low <= clamp)) sum.low = -kInfinity;
  if (told >= 1 || (clamp > 0 && sum.high >= clamp)) sum.high = kInfinity;
  return sum;
}

// The units that lead to the fragment's depth; none of them may be permitted.
Interval units_of(const OffsetPrimitive& primitive, Point place, double told) {
  constexpr double kErrors = 3e-5;  // of both products and of their sum
  const Interval of_units =
      widened(sum_of_offset(primitive, place, told) - primitive.slope, kErrors);
  const auto units = static_cast<double>(primitive.offset.units);
  const Interval unit = units > 0 ? Interval(of_units.low / units, of_units.high / units)
                                  : Interval(of_units.high / units, of_units.low / units);
  return std::isnan(unit.low) || std::isnan(unit.high) ? Interval::everything() : unit;
}

// Where most of the intervals meet; `whole` where there are none.
Interval where_most_meet(const std::vector<Interval>& units, Interval whole) {
  std::vector<std::pair<double, int>> ends;  // ends come after beginnings at the same number
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
    // Where a place is not told that may be anywhere in the pixel, the depth says nothing of r.
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
