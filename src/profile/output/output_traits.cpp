// SPDX-License-Identifier: MIT
//
// Tests, masks and polygon offsets: which alternatives a renderer follows.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "exact/interval.h"
#include "generate/scene_parts.h"
#include "profile/output/output.h"
#include "raster/attributes.h"
#include "raster/fragment_stage.h"
#include "raster/rasterizer.h"
#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

bool faces_front(const ScenePrimitive& primitive) {
  const auto at = [&](std::size_t i) { return primitive.vertices[i]->position; };
  return turn(at(1) - at(0), at(2) - at(0)) > 0;
}

SampleFragment fragment_of(const ScenePrimitive& primitive) {
  const Vertex& vertex = *primitive.vertices[0];
  SampleFragment fragment;
  std::copy_n(vertex.color.begin(), fragment.color.size(), fragment.color.begin());
  fragment.depth = (vertex.z.to_double() + 1) / 2;
  fragment.front_facing = faces_front(primitive);
  return fragment;
}

// The rendering of the triangles in a scene of cells. Each is one fragment with one colour and one
// depth, so nothing has to be rasterized.
Rendering replayed(const Scene& scene, const OutputChoice& choice) {
  const Target& target = scene.target;
  Rendering rendering;
  rendering.width = target.width;
  rendering.height = target.height;
  rendering.hits.resize(kCells);
  rendering.depths.assign(kCells, to_depth(static_cast<double>(target.clear_depth), target.depth));
  rendering.stencils.assign(kCells, target.clear_stencil);
  for (std::size_t i = 0; i < 4 * kCells; ++i)
    rendering.pixels.push_back(to_unorm8(static_cast<double>(target.clear[i % 4])));
  const FragmentStage stage(rendering, target, choice);
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const PixelPosition pixel = cell_pixel(primitive);
    stage.draw(fragment_of(primitive), primitive.state->operations,
               rendering.pixel_index(pixel.x, pixel.y));
  }
  return rendering;
}

bool is_same_pixel(const Rendering& drawn, const Rendering& exact, std::size_t pixel) {
  const auto first = static_cast<std::ptrdiff_t>(4 * pixel);
  return std::equal(drawn.pixels.begin() + first, drawn.pixels.begin() + first + 4,
                    exact.pixels.begin() + first) &&
         (drawn.stencils.empty() || drawn.stencils[pixel] == exact.stencils[pixel]);
}

bool is_same_fragment(const Fragment& a, const Fragment& b) {
  return a.x == b.x && a.y == b.y && a.primitive == b.primitive;
}

// Describes the first difference; nothing if there is none.
std::optional<std::string> difference(const Rendering& drawn, const Rendering& exact) {
  if (!std::equal(drawn.fragments.begin(), drawn.fragments.end(), exact.fragments.begin(),
                  exact.fragments.end(), is_same_fragment))
    return "fragments";
  for (std::size_t pixel = 0; pixel < drawn.hits.size(); ++pixel) {
    const bool is_counted = drawn.hits[pixel] == exact.hits[pixel];
    if (is_counted && is_same_pixel(drawn, exact, pixel)) continue;
    const auto width = static_cast<std::size_t>(drawn.width);
    return fmt::format("{} of pixel ({}, {})", is_counted ? "values" : "hits", pixel % width,
                       pixel / width);
  }
  return std::nullopt;
}

}  // namespace

Trait infer_output_rule(RuleId rule, std::span<const DrawnScene> scenes, const Choices& found) {
  Tally tally(rule);
  for (const auto& [scene, rendering] : scenes) {
    std::vector<Facts> facts;
    for (const RuleChoices& choices :
         choices_by_alternative(resolve(policy_of(found), scene.target.surface), rule)) {
      const Rendering exact = replayed(scene, choices.output);
      Facts& same = facts.emplace_back();
      for (std::size_t pixel = 0; pixel < rendering.hits.size(); ++pixel)
        same.push_back(is_same_pixel(rendering, exact, pixel));
    }
    tally.add_all(facts);
  }
  return tally.fitting(rule);
}

Trait output_agreement(TraitId id, std::span<const DrawnScene> scenes, const Choices& found) {
  Trait trait{std::move(id), "as the profile has them", {0, scenes.size()}};
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto first =
        difference(scenes[i].rendering, rasterize(scenes[i].scene, policy_of(found)));
    if (!first)
      ++trait.rate.agreeing;
    else if (trait.remark.empty())
      trait.remark = fmt::format("first in scene {}: {}", i, *first);
  }
  return trait;
}

// ----------------------------------------------------------------------------------------- offset

namespace {

// Fewer units do not measure one unit well.
constexpr float kEnoughUnits = 64;

// Product, unit and sum are rounded. With an offset no larger than the sum, four times 2^-24 of it
// bound all three errors.
constexpr double kFloatSteps = 0x1p-22;

Interval depth_under(const ScenePrimitive& primitive, const RuleChoices& choices,
                     const Target& target, Point at, OffsetPrecision precision) {
  const PrimitiveAttributes attributes = attributes_of(primitive, choices, target);
  if (precision == OffsetPrecision::float_steps)
    return widened(depth_exact(attributes, at), kFloatSteps);
  return clamped_depth(attributes, interpolate_inexact(attributes.depth, at));
}

bool has_slope(const ScenePrimitive& primitive) {
  return primitive.vertices[0]->z != primitive.vertices[1]->z ||
         primitive.vertices[0]->z != primitive.vertices[2]->z;
}

// The window depth of a vertex, without an offset.
double depth_of(const Vertex& vertex) {
  return (vertex.z.to_double() + 1) / 2;
}

}  // namespace

Trait infer_offset(const TraitId& id, OffsetPrecision precision, std::span<const DrawnScene> scenes,
                   const Choices& found) {
  Tally tally(id.rule);
  for (const auto& [scene, rendering] : scenes) {
    const auto primitives = primitives_of(scene);
    std::vector<Facts> facts;
    for (const RuleChoices& choices :
         choices_by_alternative(resolve(policy_of(found), scene.target.surface), id.rule)) {
      Facts& yields = facts.emplace_back();
      for (const Fragment& fragment : rendering.fragments) {
        if (!fragment.has_depth) continue;
        const ScenePrimitive& primitive = primitives[static_cast<std::size_t>(fragment.primitive)];
        const Point centre{Fixed::centre_of(fragment.x), Fixed::centre_of(fragment.y)};
        yields.push_back(depth_under(primitive, choices, scene.target, centre, precision)
                             .contains(fragment.depth));
      }
    }
    tally.add_all(facts);
  }
  return tally.fitting(id);
}

std::vector<MeasuredUnit> measured_units(std::span<const DrawnScene> scenes) {
  std::map<std::pair<DepthFormat, int>, MeasuredUnit> units;
  for (const auto& [scene, rendering] : scenes) {
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
