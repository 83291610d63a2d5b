// SPDX-License-Identifier: MIT
#include "tools/edgecase/protocol/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <set>

namespace edgecase {

namespace {

// In pixels: no rule of rasterization draws farther than this from the box of a primitive's
// vertices.
constexpr int kReach = 2;

bool lies_near(const Fragment& fragment, const ScenePrimitive& primitive) {
  int low[2] = {fragment.x, fragment.y};
  int high[2] = {fragment.x, fragment.y};
  for (int i = 0; i < vertices_of(primitive.kind); ++i) {
    const Point p = primitive.vertices[static_cast<std::size_t>(i)]->position;
    const std::int64_t at[2] = {p.x.raw() / Fixed::kOne, p.y.raw() / Fixed::kOne};
    for (int axis = 0; axis < 2; ++axis) {
      const int pixel = static_cast<int>(at[axis]);
      low[axis] = i == 0 ? pixel : std::min(low[axis], pixel);
      high[axis] = i == 0 ? pixel : std::max(high[axis], pixel);
    }
  }
  return low[0] - kReach <= fragment.x && fragment.x <= high[0] + kReach &&
         low[1] - kReach <= fragment.y && fragment.y <= high[1] + kReach;
}

}  // namespace

std::string color_text(const Rendering& rendering, int x, int y) {
  const std::size_t i = 4 * rendering.pixel_index(x, y);
  return fmt::format("({}, {}, {})", rendering.pixels[i], rendering.pixels[i + 1],
                     rendering.pixels[i + 2]);
}

bool shows(const Rendering& rendering, int x, int y, const int (&color)[3], int reach) {
  const std::size_t i = 4 * rendering.pixel_index(x, y);
  for (std::size_t c = 0; c < 3; ++c)
    if (std::abs(int{rendering.pixels[i + c]} - color[c]) > reach) return false;
  return true;
}

bool shows_contrast(const Rendering& rendering) {
  const auto& pixels = rendering.pixels;
  return !std::equal(pixels.begin() + 4, pixels.end(), pixels.begin());
}

std::optional<Fault> fault_of_empty(const Scene& scene, const Rendering& rendering) {
  if (!rendering.fragments.empty())
    return Fault{fmt::format("it tells {} fragments of a scene that draws nothing",
                             rendering.fragments.size()),
                 "list a fragment for each pixel that a primitive covers, and no other"};
  for (int y = 0; y < scene.target.height; ++y)
    for (int x = 0; x < scene.target.width; ++x)
      if (!shows(rendering, x, y, {255, 0, 0}, 0))
        return Fault{fmt::format("pixel ({}, {}) is {}, and the clear colour is (255, 0, 0)", x, y,
                                 color_text(rendering, x, y)),
                     "begin with target.clear in every pixel"};
  return std::nullopt;
}

std::optional<Fault> fault_of_feature(const FeatureScene& feature, const Rendering& rendering) {
  const auto& [red, green, blue] = feature.color;
  if (shows(rendering, feature.x, feature.y, feature.color, feature.reach)) return std::nullopt;
  return Fault{
      fmt::format("pixel ({}, {}) is {} where ({}, {}, {}) was asked for", feature.x, feature.y,
                  color_text(rendering, feature.x, feature.y), red, green, blue),
      kRefuse};
}

bool lists_failing(const FeatureScene& feature, const Rendering& rendering) {
  if (feature.failed_test.empty() || rendering.fragments.empty()) return true;
  return std::any_of(rendering.fragments.begin(), rendering.fragments.end(),
                     [](const Fragment& fragment) { return fragment.primitive == 1; });
}

std::optional<Fault> fault_of_drawing(const Scene& scene, const Rendering& rendering) {
  const auto primitives = primitives_of(scene);
  std::set<int> drawn;
  for (const Fragment& fragment : rendering.fragments) {
    drawn.insert(fragment.primitive);
    if (!lies_near(fragment, primitives[static_cast<std::size_t>(fragment.primitive)]))
      return Fault{fmt::format("primitive {} has a fragment at ({}, {}), far from its vertices",
                               fragment.primitive, fragment.x, fragment.y),
                   "number primitives from 0 as they are assembled; y points up"};
    if (shows(rendering, fragment.x, fragment.y, {0, 0, 0}, 0))
      return Fault{
          fmt::format("pixel ({}, {}) has a white fragment and is black", fragment.x, fragment.y),
          "tell pixels row by row from the bottom, where fragments have them"};
  }
  for (const ScenePrimitive& primitive : primitives)
    if (!drawn.contains(primitive.index))
      return Fault{
          fmt::format("primitive {} of {} has no fragment", primitive.index, primitives.size()),
          "see \"Primitives\" for which vertices make which one, or refuse the type"};
  return std::nullopt;
}

std::optional<Fault> fault_of_values(const Rendering& rendering) {
  const auto is_finite = [](double n) { return std::isfinite(n); };
  for (const Fragment& fragment : rendering.fragments) {
    const bool finite =
        !fragment.has_color || std::all_of(fragment.color.begin(), fragment.color.end(), is_finite);
    const bool in_range = !fragment.has_depth || (0 <= fragment.depth && fragment.depth <= 1);
    if (finite && in_range) continue;
    return Fault{fmt::format("the fragment of primitive {} at ({}, {}) has {}", fragment.primitive,
                             fragment.x, fragment.y,
                             finite ? "a depth beyond 0 to 1" : "a colour that is not finite"),
                 "a primitive without length or area has no fragments: divide by neither"};
  }
  return std::nullopt;
}

}  // namespace edgecase
