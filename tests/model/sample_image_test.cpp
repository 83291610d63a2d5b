// SPDX-License-Identifier: MIT
#include "model/sample_image.h"

#include <gtest/gtest.h>

namespace edgecase {
namespace {

Fragment fragment(int x, std::uint32_t coverage) {
  Fragment made;
  made.x = x;
  made.coverage = coverage;
  return made;
}

TEST(SampleImage, HoldsWhatARenderingTellsOfItsSamples) {
  Rendering rendering;
  rendering.width = 2;
  rendering.height = 1;
  rendering.samples = 2;
  rendering.sample_positions = {centre_of_pixel(), {}};
  rendering.sample_pixels.assign(16, 7);
  rendering.hits = {1, 0, 0, 1};
  rendering.fragments = {fragment(0, 1), fragment(1, 1), fragment(1, 2)};
  const SampleImage image = sample_image(rendering);
  EXPECT_EQ(image.samples, 2);
  EXPECT_EQ(image.positions, rendering.sample_positions);
  EXPECT_EQ(image.pixels->bytes(), rendering.sample_pixels);
  EXPECT_EQ(image.hits->words(), rendering.hits);
  EXPECT_EQ(image.coverage->words(), (std::vector<std::uint32_t>{1, 3}));
}

TEST(SampleImage, OfOneSampleThereIsNothing) {
  Rendering rendering;
  rendering.width = rendering.height = 1;
  rendering.hits = {1};
  rendering.fragments = {fragment(0, 1)};
  EXPECT_EQ(sample_image(rendering), SampleImage{});
}

}  // namespace
}  // namespace edgecase
