// SPDX-License-Identifier: MIT
//
// Tests, masks and polygon offsets: which alternatives a renderer follows.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "exact/interval.h"
#include "generate/random_shapes.h"
#include "model/rendering.h"
#include "profile/output/output.h"
#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "rules/values/framebuffer.h"

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

// The codes that a renderer stores for numbers and blended colours.

namespace {

double as_float(double value) {
  return static_cast<double>(static_cast<float>(value));
}

}  // namespace

long code_by(CodeRounding rounding, double value, int bits) {
  const double power = std::ldexp(1.0, bits);
  const double largest = power - 1;
  const double clamped = std::clamp(value, 0.0, 1.0);
  // 24 bits times 24 bits: exact.
  const double product = clamped * largest;
  const auto code = [&]() -> double {
    switch (rounding) {
      case CodeRounding::nearest:
        return std::nearbyint(product);
      case CodeRounding::nearest_of_float:
        return std::nearbyint(as_float(product));
      case CodeRounding::half_up_of_float:
        return std::floor(as_float(as_float(product) + 0.5));
      case CodeRounding::truncated:
        return std::floor(product);
      case CodeRounding::truncated_of_float:
        return std::floor(as_float(product));
      case CodeRounding::up:
        return std::ceil(product);
      case CodeRounding::power_nearest:
        return std::nearbyint(clamped * power);
      case CodeRounding::power_truncated:
        return std::floor(clamped * power);
    }
    return 0;
  };
  return static_cast<long>(std::min(code(), largest));
}

CodeTally::CodeTally(std::string id, int bits) : tally_(names_of<CodeRounding>()) {
  evidence_.id = std::move(id);
  evidence_.bits = bits;
}

void CodeTally::add(double value, long code) {
  std::vector<bool> yields;
  for (const CodeRounding rounding : values_of<CodeRounding>())
    yields.push_back(code_by(rounding, value, evidence_.bits) == code);
  tally_.add(yields);
  const double product = std::clamp(value, 0.0, 1.0) * (std::ldexp(1.0, evidence_.bits) - 1);
  const double below = std::floor(product);
  ++evidence_.numbers;
  CodeStep& step = evidence_.steps[code - static_cast<long>(below)];
  const double above = product - below;
  step.least = step.numbers == 0 ? above : std::min(step.least, above);
  step.largest = std::max(step.largest, above);
  ++step.numbers;
}

// ----------------------------------------------------------------------------------------- colours

namespace {

// A cell in which the colour of the second triangle met the stored colour of the first.
struct BlendedCell {
  const FragmentOperations* operations = nullptr;
  std::array<double, 4> source{};
  Rgba8 destination{};
  Rgba8 stored{};
};

std::array<double, 4> color_of(const ScenePrimitive& primitive) {
  std::array<double, 4> color{};
  std::copy_n(primitive.vertices[0]->color.begin(), color.size(), color.begin());
  return color;
}

// As written by the first draw; its colours are codes.
Rgba8 codes_of(const ScenePrimitive& primitive) {
  Rgba8 codes{};
  const std::array<double, 4> color = color_of(primitive);
  std::transform(color.begin(), color.end(), codes.begin(), to_unorm8);
  return codes;
}

Rgba8 stored_at(const Rendering& rendering, PixelPosition pixel) {
  Rgba8 stored{};
  std::copy_n(rendering.pixels.begin() +
                  static_cast<std::ptrdiff_t>(4 * rendering.pixel_index(pixel.x, pixel.y)),
              stored.size(), stored.begin());
  return stored;
}

std::vector<BlendedCell> blended_cells(const DrawnScene& drawn) {
  std::map<PixelPosition, Rgba8> first;
  std::vector<BlendedCell> cells;
  for (const ScenePrimitive& primitive : primitives_of(drawn.scene)) {
    const PixelPosition pixel = cell_pixel(primitive);
    if (primitive.draw == 0)
      first.emplace(pixel, codes_of(primitive));
    else
      cells.push_back({&primitive.state->operations, color_of(primitive), first.at(pixel),
                       stored_at(drawn.rendering, pixel)});
  }
  return cells;
}

bool is_permitted(const BlendedCell& cell, BlendMethod method) {
  std::array<Interval, 4> source;
  Rgba8Range destination;
  for (std::size_t i = 0; i < 4; ++i) {
    source[i] = Interval(cell.source[i]);
    destination[i] = {cell.destination[i], cell.destination[i]};
  }
  const Rgba8Range permitted = permitted_color(*cell.operations, source, destination, method);
  for (std::size_t i = 0; i < 4; ++i)
    if (cell.stored[i] < permitted[i].low || cell.stored[i] > permitted[i].high) return false;
  return true;
}

}  // namespace

void add_plain_colors(std::span<const DrawnScene> scenes, CodeTally& tally) {
  for (const DrawnScene& drawn : scenes)
    for (const ScenePrimitive& primitive : primitives_of(drawn.scene)) {
      const Rgba8 stored = stored_at(drawn.rendering, cell_pixel(primitive));
      const std::array<double, 4> color = color_of(primitive);
      for (std::size_t i = 0; i < 4; ++i) tally.add(color[i], stored[i]);
    }
}

Trait infer_blend_method(std::span<const DrawnScene> scenes) {
  Tally tally(RuleId::blend_equation);
  for (const DrawnScene& drawn : scenes)
    for (const BlendedCell& cell : blended_cells(drawn)) {
      std::vector<bool> yields;
      for (const BlendMethod method : values_of<BlendMethod>())
        yields.push_back(is_permitted(cell, method));
      tally.add(yields);
    }
  return tally.fitting(RuleId::blend_equation);
}

Trait infer_blend_rounding(std::span<const DrawnScene> scenes, BlendMethod method) {
  Tally tally(RuleId::blend_rounding);
  for (const DrawnScene& drawn : scenes)
    for (const BlendedCell& cell : blended_cells(drawn)) {
      std::vector<Rgba8> written;
      for (const BlendRounding rounding : values_of<BlendRounding>())
        written.push_back(written_color(*cell.operations, cell.source, cell.destination,
                                        {method, rounding, ColorMaskMethod::as_set}));
      for (std::size_t i = 0; i < 4; ++i) {
        std::vector<bool> yields;
        for (const Rgba8& color : written) yields.push_back(color[i] == cell.stored[i]);
        tally.add(yields);
      }
    }
  return tally.fitting(RuleId::blend_rounding);
}

std::vector<BlendResidual> blend_residuals(std::span<const DrawnScene> scenes,
                                           const BlendChoice& choice) {
  std::map<std::tuple<bool, BlendEquation, BlendFactor, BlendFactor>, BlendResidual> by_term;
  for (const DrawnScene& drawn : scenes)
    for (const BlendedCell& cell : blended_cells(drawn)) {
      const Rgba8 written = written_color(*cell.operations, cell.source, cell.destination, choice);
      for (std::size_t i = 0; i < 4; ++i) {
        const bool is_alpha = i == 3;
        const Blending& blending = *cell.operations->blending;
        const BlendTerm& term = is_alpha ? blending.alpha : blending.color;
        BlendResidual& residual = by_term[{is_alpha, term.equation, term.source, term.destination}];
        residual.term = term;
        residual.is_alpha = is_alpha;
        ++residual.values;
        if (cell.stored[i] != written[i]) ++residual.off[cell.stored[i] - written[i]];
      }
    }
  std::vector<BlendResidual> residuals;
  for (auto& [term, residual] : by_term)
    if (residual.wrong() > 0) residuals.push_back(std::move(residual));
  std::stable_sort(
      residuals.begin(), residuals.end(),
      [](const BlendResidual& a, const BlendResidual& b) { return a.wrong() > b.wrong(); });
  return residuals;
}

}  // namespace edgecase
