// SPDX-License-Identifier: MIT
#include "profile/output/output_traits.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "generate/scene_parts.h"
#include "profile/output/cells.h"
#include "profile/rule_tally.h"
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

// What the triangles of a scene of cells leave behind. Each is one fragment, of one colour and one
// depth: nothing needs to be rasterized.
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

bool is_same_pixel(const Rendering& told, const Rendering& exact, std::size_t pixel) {
  const auto first = static_cast<std::ptrdiff_t>(4 * pixel);
  return std::equal(told.pixels.begin() + first, told.pixels.begin() + first + 4,
                    exact.pixels.begin() + first) &&
         (told.stencils.empty() || told.stencils[pixel] == exact.stencils[pixel]);
}

bool is_same_place(const Fragment& a, const Fragment& b) {
  return a.x == b.x && a.y == b.y && a.primitive == b.primitive;
}

// What differs first, in words; none: nothing.
std::optional<std::string> difference(const Rendering& told, const Rendering& exact) {
  if (!std::equal(told.fragments.begin(), told.fragments.end(), exact.fragments.begin(),
                  exact.fragments.end(), is_same_place))
    return "fragments";
  for (std::size_t pixel = 0; pixel < told.hits.size(); ++pixel) {
    const bool is_counted = told.hits[pixel] == exact.hits[pixel];
    if (is_counted && is_same_pixel(told, exact, pixel)) continue;
    const auto width = static_cast<std::size_t>(told.width);
    return fmt::format("{} of pixel ({}, {})", is_counted ? "values" : "hits", pixel % width,
                       pixel / width);
  }
  return std::nullopt;
}

}  // namespace

Trait infer_output_rule(const std::string& rule, std::span<const DrawnScene> told,
                        const Choices& found) {
  Tally tally = tally_of(rule);
  for (const auto& [scene, rendering] : told) {
    std::vector<Facts> facts;
    for (const std::string& name : names_of_alternatives(rule)) {
      const Policy policy = policy_with(found, rule, name);
      const Rendering exact = replayed(scene, resolve(policy, scene.target.surface).output);
      Facts& same = facts.emplace_back();
      for (std::size_t pixel = 0; pixel < rendering.hits.size(); ++pixel)
        same.push_back(is_same_pixel(rendering, exact, pixel));
    }
    add_all(tally, facts);
  }
  return tally.fitting(rule);
}

Trait output_agreement(std::string id, std::span<const DrawnScene> told, const Choices& found) {
  Trait trait{std::move(id), "as the profile has them", {0, told.size()}, "", {}, ""};
  Policy policy;
  policy.rules = found;
  for (std::size_t i = 0; i < told.size(); ++i) {
    const auto first = difference(told[i].rendering, rasterize(told[i].scene, policy));
    if (!first)
      ++trait.rate.agreeing;
    else if (trait.remark.empty())
      trait.remark = fmt::format("first in scene {}: {}", i, *first);
  }
  return trait;
}

}  // namespace edgecase
