// SPDX-License-Identifier: MIT
//
// Drawings of masks against renderings, told as an author needs it.
#include "suite/expectation_check.h"

#include <gmock/gmock.h>

#include <array>
#include <utility>

namespace edgecase {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Each fragment hits the samples that it covers.
void count_hits(Rendering& rendering) {
  rendering.hits.assign(static_cast<std::size_t>(4 * rendering.samples), 0);
  for (const Fragment& fragment : rendering.fragments)
    for (int s = 0; s < rendering.samples; ++s)
      rendering.hits[rendering.sample_index(fragment.x, fragment.y, s)] +=
          fragment.coverage >> s & 1;
}

// 2 x 2 pixels of 8 samples; (1, 0) has two fragments, as of a shader that runs for each sample.
Rendering small_rendering() {
  Rendering rendering;
  rendering.width = rendering.height = 2;
  rendering.samples = 8;
  for (const auto& [x, y, coverage] : {std::array{1, 0, 0x10}, {1, 0, 0x02}, {0, 1, 0x0b}}) {
    Fragment fragment;
    fragment.x = x;
    fragment.y = y;
    fragment.coverage = static_cast<std::uint32_t>(coverage);
    rendering.fragments.push_back(fragment);
  }
  count_hits(rendering);
  return rendering;
}

Case case_with(std::vector<std::uint32_t> masks) {
  Case one;
  one.expect.resize(1);
  one.expect[0].masks = std::move(masks);
  one.expect[0].where = "a.json:3: /expect/0/masks";
  return one;
}

TEST(ExpectationCheck, MasksAreTheUnionOfFragments) {
  const PixelMasks masks = masks_of(small_rendering());
  EXPECT_THAT(masks.covered, ElementsAre(0, 0x12, 0x0b, 0));
  EXPECT_THAT(masks.doubly, ElementsAre(0, 0, 0, 0));
  EXPECT_EQ(draw_masks(masks.covered, 2, 2), " b  .\n . 12\n");
  EXPECT_EQ(draw_masks({0, 0}, 1, 2), ".\n.\n");
}

TEST(ExpectationCheck, DrawingsOfMasksAreMetBitByBit) {
  const Rendering exact = small_rendering();
  EXPECT_THAT(unmet_drawings(case_with({0, 0x12, 0x0b, 0}), "opengl", exact), IsEmpty());
  EXPECT_THAT(unmet_drawings(case_with({0, 0x13, 0x0b, 0}), "another", exact), IsEmpty());
  EXPECT_THAT(unmet_drawings(case_with({0, 0x12, 0x0b, 0x80}), "opengl", exact),
              ElementsAre("a.json:3: /expect/0/masks: under policy opengl, the drawing has 80 at "
                          "pixel (1, 1), exact has 0; exact draws\n b  .\n . 12\n"));
  for (const std::uint32_t wrong : {0x10U, 0x02U, 0x13U, 0U})
    EXPECT_THAT(unmet_drawings(case_with({0, wrong, 0x0b, 0}), "opengl", exact),
                ElementsAre(HasSubstr("at pixel (1, 0), exact has 12")));
}

TEST(ExpectationCheck, NoSampleIsCoveredTwice) {
  Rendering exact = small_rendering();
  exact.fragments.push_back(exact.fragments[0]);
  EXPECT_THAT(unmet_drawings(case_with({0, 0x12, 0x0b, 0}), "opengl", exact),
              ElementsAre(HasSubstr("exact covers samples 10 of pixel (1, 0) twice")));
}

TEST(ExpectationCheck, HitsAreThoseOfSamplesInAllPasses) {
  EXPECT_THAT(hits_of(small_rendering()), ElementsAre(0, 2, 3, 0));
  Rendering supersampled;
  supersampled.width = supersampled.height = 2;
  supersampled.passes = {small_rendering(), small_rendering()};
  for (Rendering& pass : supersampled.passes) {
    pass.samples = 1;
    for (Fragment& fragment : pass.fragments) fragment.coverage = 1;
    count_hits(pass);
  }
  EXPECT_THAT(hits_of(supersampled), ElementsAre(0, 4, 2, 0));
  EXPECT_EQ(draw_hits({0, 1, 2, 10}, 2, 2), "2+\n.#\n");
}

// A fragment that fails a test hits nothing.
TEST(ExpectationCheck, HitsAreNotFragments) {
  Rendering exact = small_rendering();
  exact.hits[exact.sample_index(0, 1, 3)] = 0;
  EXPECT_THAT(hits_of(exact), ElementsAre(0, 2, 2, 0));
}

TEST(ExpectationCheck, DrawingsOfHitsAreMetPixelByPixel) {
  Case one;
  one.expect.resize(1);
  one.expect[0].coverage = {0, 2, 1, 0};
  Rendering exact = small_rendering();
  exact.samples = 1;
  for (Fragment& fragment : exact.fragments) fragment.coverage = 1;
  count_hits(exact);
  EXPECT_THAT(unmet_drawings(one, "opengl", exact), IsEmpty());
  one.expect[0].coverage[3] = 1;
  EXPECT_THAT(unmet_drawings(one, "opengl", exact),
              ElementsAre(HasSubstr("under policy opengl, the drawing has 1 at pixel (1, 1), "
                                    "exact has 0; exact draws\n#.\n.2\n")));
}

}  // namespace
}  // namespace edgecase
