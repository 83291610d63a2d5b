// SPDX-License-Identifier: MIT
#include "model/sample_image.h"

#include <cstdint>
#include <vector>

namespace edgecase {

SampleImage sample_image(const Rendering& rendering) {
  SampleImage image;
  if (rendering.samples <= 1) return image;
  image.samples = rendering.samples;
  image.positions = rendering.sample_positions;
  image.pixels = rendering.sample_pixels;
  image.hits = rendering.hits;
  std::vector<std::uint32_t> coverage(rendering.pixel_index(0, rendering.height));
  for (const Fragment& fragment : rendering.fragments)
    coverage[rendering.pixel_index(fragment.x, fragment.y)] |= fragment.coverage;
  image.coverage = coverage;
  return image;
}

}  // namespace edgecase
