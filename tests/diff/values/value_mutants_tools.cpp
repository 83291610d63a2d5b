// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "raster/attributes.h"
#include "rules/values/framebuffer.h"
#include "tests/diff/values/value_mutants.h"

namespace edgecase {
namespace {

Rendering shaded(const Scene& scene, Rendering rendering, const RuleChoices& choices,
                 bool with_details) {
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  for (Fragment& f : rendering.fragments) {
    const ScenePrimitive& primitive = primitives.at(static_cast<std::size_t>(f.primitive));
    const PrimitiveAttributes attributes = attributes_of(primitive, choices, scene.target);
    const int detail = f.detail;
    const PixelPosition pixel{f.x, f.y};
    f = shade(primitive, attributes, pixel);
    f.detail = detail;
    if (!with_details || detail < 0) continue;
    CentreColors colors(scene.target.width);
    colors.take(attributes.color);
    rendering.details.at(static_cast<std::size_t>(detail)) =
        shade_details(attributes, colors, quad_of(pixel, choices.values, scene.target),
                      choices.values, scene.details);
  }
  return stored(scene, std::move(rendering));
}

void change_one(const Scene& scene, Rendering& rendering, std::size_t i,
                const FragmentChange& change) {
  Fragment& fragment = rendering.fragments.at(i);
  change(scene, fragment, rendering.details.at(static_cast<std::size_t>(fragment.detail)));
}

}  // namespace

Rendering stored(const Scene& scene, Rendering rendering) {
  for (const Fragment& f : rendering.fragments) {
    const std::size_t pixel = rendering.pixel_index(f.x, f.y);
    for (std::size_t c = 0; c < 4; ++c) rendering.pixels[4 * pixel + c] = to_unorm8(f.color[c]);
    if (!rendering.depths.empty()) rendering.depths[pixel] = to_depth(f.depth, scene.target.depth);
  }
  return rendering;
}

Rendering shaded_under(const Scene& scene, const Rendering& exact, const RuleChoices& choices) {
  return shaded(scene, exact, choices, true);
}

Rendering colored_under(const Scene& scene, const Rendering& exact, const RuleChoices& choices) {
  return shaded(scene, exact, choices, false);
}

ValueMutation all_fragments(FragmentChange change) {
  return [change = std::move(change)](const Scene& scene, const Rendering& exact) {
    Rendering rendering = exact;
    for (std::size_t i = 0; i < rendering.fragments.size(); ++i)
      change_one(scene, rendering, i, change);
    return stored(scene, std::move(rendering));
  };
}

ValueMutation middle_fragment(FragmentChange change) {
  return [change = std::move(change)](const Scene& scene, const Rendering& exact) {
    Rendering rendering = exact;
    change_one(scene, rendering, rendering.fragments.size() / 2, change);
    return stored(scene, std::move(rendering));
  };
}

PrimitiveAttributes exact_attributes(const Scene& scene, const Fragment& fragment) {
  const ScenePrimitive primitive =
      primitives_of(scene).at(static_cast<std::size_t>(fragment.primitive));
  return attributes_of(primitive, {}, scene.target);
}

double float_above(double value) {
  return static_cast<double>(std::nextafterf(static_cast<float>(value), HUGE_VALF));
}

double float_below(double value) {
  return static_cast<double>(std::nextafterf(static_cast<float>(value), -HUGE_VALF));
}

}  // namespace edgecase
