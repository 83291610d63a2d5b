// SPDX-License-Identifier: MIT
#include "model/sampling.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace edgecase {
Point place_in(PixelPosition pixel, Point within) {
  return {Fixed::from_integer(pixel.x) + within.x, Fixed::from_integer(pixel.y) + within.y};
}

int least_invocations(const Multisampling& multisampling, int samples) {
  if (!multisampling.enabled) return 1;
  if (multisampling.location == AttributeLocation::sample) return samples;
  // A float32 times a small integer is exact in a double.
  const double share = static_cast<double>(multisampling.min_sample_shading.value_or(0));
  return std::clamp(static_cast<int>(std::ceil(share * samples)), 1, samples);
}

}  // namespace edgecase
