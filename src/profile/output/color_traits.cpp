// SPDX-License-Identifier: MIT
//
// The codes that a renderer stores for numbers and blended colours.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "model/rendering.h"
#include "profile/output/output.h"

namespace edgecase {
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

// A draw's operations as understood by the method.
FragmentOperations operations_by(FragmentOperations operations, BlendMethod method) {
  if (method == BlendMethod::ignored)
    operations.blending.reset();
  else
    operations.blending = blending_by(*operations.blending, method);
  return operations;
}

bool is_permitted(const BlendedCell& cell, BlendMethod method) {
  std::array<Interval, 4> source;
  Rgba8Range destination;
  for (std::size_t i = 0; i < 4; ++i) {
    source[i] = Interval(cell.source[i]);
    destination[i] = {cell.destination[i], cell.destination[i]};
  }
  const Rgba8Range permitted =
      permitted_color(operations_by(*cell.operations, method), source, destination);
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
