// SPDX-License-Identifier: MIT
#include "model/sample_image.h"

namespace edgecase {

SampleImage sample_image(const Rendering& rendering) {
  SampleImage image;
  if (rendering.samples <= 1) return image;
  image.samples = rendering.samples;
  image.positions = rendering.sample_positions;
  image.pixels = rendering.sample_pixels;
  image.hits = rendering.hits;
  image.coverage.assign(
      static_cast<std::size_t>(rendering.width) * static_cast<std::size_t>(rendering.height), 0);
  for (const Fragment& fragment : rendering.fragments)
    image.coverage[rendering.pixel_index(fragment.x, fragment.y)] |= fragment.coverage;
  return image;
}

}  // namespace edgecase
