// SPDX-License-Identifier: MIT
#include "profile/output/offset_traits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "exact/interval.h"
#include "profile/rule_tally.h"
#include "raster/attributes.h"
#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

// Units are told to this many places by offsets of so many of them.
constexpr float kEnoughUnits = 64;

// Product and unit are rounded, and the sum: with an offset that is no larger than the sum, four
// times 2^-24 of it hold all three.
constexpr double kFloatSteps = 0x1p-22;

Interval depth_under(const ScenePrimitive& primitive, const RuleChoices& choices,
                     const Target& target, Point place, OffsetPrecision precision) {
  const PrimitiveAttributes attributes = attributes_of(primitive, choices, target);
  if (precision == OffsetPrecision::float_steps)
    return widened(depth_exact(attributes, place), kFloatSteps);
  return clamped_depth(attributes, interpolate_inexact(attributes.depth, place));
}

bool has_slope(const ScenePrimitive& primitive) {
  return primitive.vertices[0]->z != primitive.vertices[1]->z ||
         primitive.vertices[0]->z != primitive.vertices[2]->z;
}

// The depth of a vertex in the window, without an offset.
double depth_of(const Vertex& vertex) {
  return (vertex.z.to_double() + 1) / 2;
}

}  // namespace

Trait infer_offset(const std::string& rule, std::string id, OffsetPrecision precision,
                   std::span<const DrawnScene> told, const Choices& found) {
  Tally tally = tally_of(rule);
  for (const auto& [scene, rendering] : told) {
    const auto primitives = primitives_of(scene);
    std::vector<Facts> facts;
    for (const std::string& name : names_of_alternatives(rule)) {
      const RuleChoices choices = resolve(policy_with(found, rule, name), scene.target.surface);
      Facts& yields = facts.emplace_back();
      for (const Fragment& fragment : rendering.fragments) {
        if (!fragment.has_depth) continue;
        const ScenePrimitive& primitive = primitives[static_cast<std::size_t>(fragment.primitive)];
        const Point centre{Fixed::centre_of(fragment.x), Fixed::centre_of(fragment.y)};
        yields.push_back(depth_under(primitive, choices, scene.target, centre, precision)
                             .contains(fragment.depth));
      }
    }
    add_all(tally, facts);
  }
  return tally.fitting(std::move(id));
}

std::vector<MeasuredUnit> measured_units(std::span<const DrawnScene> told) {
  std::map<std::pair<DepthFormat, int>, MeasuredUnit> units;
  for (const auto& [scene, rendering] : told) {
    const auto primitives = primitives_of(scene);
    const int bits = bits_of(scene.target.depth);
    for (const Fragment& fragment : rendering.fragments) {
      const ScenePrimitive& primitive = primitives[static_cast<std::size_t>(fragment.primitive)];
      const float asked = primitive.state->polygon_offset->units;
      if (!fragment.has_depth || has_slope(primitive) || std::abs(asked) < kEnoughUnits) continue;
      const double depth = depth_of(*primitive.vertices[0]);
      const int exponent = bits > 0 ? 0 : std::ilogb(depth);
      const double one =
          bits > 0 ? 1 / (std::ldexp(1.0, bits) - 1) : std::ldexp(1.0, exponent - 23);
      const double unit = (fragment.depth - depth) / static_cast<double>(asked) / one;
      MeasuredUnit& measured = units[{scene.target.depth, -exponent}];
      measured.format = scene.target.depth;
      measured.exponent = exponent;
      measured.least = measured.depths == 0 ? unit : std::min(measured.least, unit);
      measured.largest = measured.depths == 0 ? unit : std::max(measured.largest, unit);
      ++measured.depths;
    }
  }
  std::vector<MeasuredUnit> result;
  for (const auto& [key, unit] : units) result.push_back(unit);
  return result;
}

}  // namespace edgecase
