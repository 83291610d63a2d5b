// SPDX-License-Identifier: MIT
#include "profile/textures/texture_evidence.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace edgecase {
namespace {

// A step through a list that meets everything in it, and no rows or columns of it alone.
std::size_t spreading_step(std::size_t count) {
  auto step = static_cast<std::size_t>(0.618 * static_cast<double>(count));
  while (step > 1 && std::gcd(step, count) != 1) --step;
  return std::max<std::size_t>(step, 1);
}

}  // namespace

std::vector<ToldLookup> told_lookups(const Rendering& rendering, std::size_t most) {
  std::vector<ToldLookup> result;
  const std::size_t count = rendering.fragments.size();
  const std::size_t taken = std::min(count, most);
  const std::size_t step = taken == count ? 1 : spreading_step(count);
  for (std::size_t i = 0; i < taken; ++i) {
    const Fragment& fragment = rendering.fragments[i * step % count];
    if (!fragment.has_color) continue;
    ToldLookup lookup;
    lookup.pixel = {fragment.x, fragment.y};
    lookup.primitive = fragment.primitive;
    lookup.color = fragment.color;
    if (fragment.detail >= 0) {
      const FragmentDetail& detail = rendering.details[static_cast<std::size_t>(fragment.detail)];
      lookup.coordinates = detail.texture_coordinates;
      if (detail.level_of_detail) lookup.lambda_prime = (*detail.level_of_detail)[1];
    }
    result.push_back(lookup);
  }
  return result;
}

ToldScene told_scene(Scene scene, const Rendering& rendering, std::size_t most) {
  return {std::move(scene), told_lookups(rendering, most)};
}

}  // namespace edgecase
