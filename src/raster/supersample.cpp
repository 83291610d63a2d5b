// SPDX-License-Identifier: MIT
#include "raster/supersample.h"

#include <algorithm>
#include <array>

#include "rules/choices.h"

namespace edgecase {
namespace {

using Components = std::array<double, 4>;

// What each pass shows, pixel after pixel.
class ShownColors {
 public:
  ShownColors(const Target& target, std::span<const Rendering> passes)
      : passes_(passes), next_(passes.size()) {
    std::copy(target.clear.begin(), target.clear.end(), clear_.begin());
  }

  // Of pass k; pixels must be asked for in their order.
  const Components& at(std::size_t k, int x, int y) {
    const auto& fragments = passes_[k].fragments;
    const Components* shown = &clear_;
    std::size_t& next = next_[k];
    for (; next < fragments.size() && fragments[next].x == x && fragments[next].y == y; ++next)
      shown = &fragments[next].color;
    return *shown;
  }

 private:
  std::span<const Rendering> passes_;
  std::vector<std::size_t> next_;  // by pass: the first fragment that has not been shown
  Components clear_{};
};

}  // namespace

void for_each_shown(const Scene& scene, std::span<const Rendering> passes,
                    const std::function<void(std::span<const double>)>& visit) {
  ShownColors colors(scene.target, passes);
  std::array<std::vector<double>, 4> shown;
  for (auto& values : shown) values.resize(passes.size());
  for (int y = 0; y < scene.target.height; ++y) {
    for (int x = 0; x < scene.target.width; ++x) {
      for (std::size_t k = 0; k < passes.size(); ++k) {
        const Components& color = colors.at(k, x, y);
        for (std::size_t c = 0; c < color.size(); ++c) shown[c][k] = color[c];
      }
      for (const auto& values : shown) visit(values);
    }
  }
}

std::vector<double> accumulated_image(const Scene& scene, std::span<const Rendering> passes,
                                      Accumulation choice) {
  std::vector<double> image;
  for_each_shown(scene, passes, [&](std::span<const double> shown) {
    image.push_back(accumulated(shown, scene.supersampling, choice));
  });
  return image;
}

Rendering draw_passes(const Scene& scene, const Policy& policy, DrawPass draw) {
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k)
    rendering.passes.push_back(draw(pass_of(scene, k), policy, {}));
  const RuleChoices choices = resolve(policy, scene.target.surface);
  rendering.accumulated = accumulated_image(scene, rendering.passes, choices.samples.accumulation);
  rendering.pixels.reserve(rendering.accumulated.size());
  for (const double component : rendering.accumulated)
    rendering.pixels.push_back(to_unorm8(component));
  return rendering;
}

}  // namespace edgecase
