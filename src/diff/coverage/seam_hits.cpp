// SPDX-License-Identifier: MIT
#include "diff/coverage/seam_hits.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace edgecase {

long hits_at(std::span<const PixelPosition> pixels, PixelPosition p) {
  const auto [first, last] = std::equal_range(
      pixels.begin(), pixels.end(), p,
      [](PixelPosition a, PixelPosition b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
  return last - first;
}

PixelBounds bounds_near(Point a, Point b, const PixelBounds& target) {
  const auto [x_low, x_high] = std::minmax(a.x, b.x);
  const auto [y_low, y_high] = std::minmax(a.y, b.y);
  const auto clip = [](std::int64_t value) {
    return static_cast<int>(
        std::clamp<std::int64_t>(value, -2 * Fixed::kMaxCoordinate, 2 * Fixed::kMaxCoordinate));
  };
  return common_part(target, {clip(x_low.floor() - 1), clip(y_low.floor() - 1),
                              clip(x_high.floor() + 1), clip(y_high.floor() + 1)});
}

std::map<int, Point> shared_samples(const ScenePrimitive& first, const ScenePrimitive& second,
                                    const Target& target, const SamplePositions& positions) {
  if (!is_multisampled(*first.state, target)) return {{0, centre_of_pixel()}};
  const std::uint32_t mask = first.state->multisampling.mask & second.state->multisampling.mask;
  std::map<int, Point> samples;
  for (std::size_t s = 0; s < positions.size(); ++s)
    if ((mask >> s & 1) != 0) samples.emplace(static_cast<int>(s), positions[s]);
  return samples;
}

}  // namespace edgecase
