// SPDX-License-Identifier: MIT
//
// Disagreements say which sample they are about, and mark where it lies.
#include <gtest/gtest.h>

#include <algorithm>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

Scene covered_scene(int samples) {
  const auto at = [](int x, int y) {
    return Point{Fixed::from_integer(x), Fixed::from_integer(y)};
  };
  return multisampled_scene(4, samples, Primitive::triangles, {at(0, 0), at(4, 0), at(0, 4)});
}

const Disagreement* find(const Result& result, const std::string& rule) {
  const auto found = std::ranges::find(result.disagreements, rule_named(rule), &Disagreement::rule);
  return found == result.disagreements.end() ? nullptr : &*found;
}

TEST(SamplePlaces, AWrongColourIsMarkedAtItsSample) {
  const Scene scene = covered_scene(4);
  const Rendering exact = rasterize(scene, {});
  for (int sample = 0; sample < 4; ++sample) {
    Rendering rendered = exact;
    rendered.sample_pixels[4 * rendered.sample_index(1, 1, sample)] ^= 0x80;
    const Result result = compare(scene, {}, exact, rendered, {8, nullptr});
    const Disagreement* d = find(result, "framebuffer.unorm8");
    ASSERT_NE(d, nullptr);
    EXPECT_EQ(d->sample, sample);
    const Point at = exact.sample_positions[static_cast<std::size_t>(sample)];
    ASSERT_EQ(d->figure.marks.size(), 1U);
    EXPECT_EQ(d->figure.marks[0].points[0],
              (std::pair{1 + at.x.to_double(), 1 + at.y.to_double()}));
  }
}

TEST(SamplePlaces, AResolvedPixelIsAboutNoSample) {
  const Scene scene = covered_scene(4);
  const Rendering exact = rasterize(scene, {});
  Rendering rendered = exact;
  // Of samples that are alike around it.
  const std::size_t alpha = 4 * rendered.pixel_index(1, 1) + 3;
  rendered.pixels[alpha] = rendered.pixels[alpha] < 128 ? 255 : 0;
  const Result result = compare(scene, {}, exact, rendered, {8, nullptr});
  const Disagreement* d = find(result, "sample.resolve");
  ASSERT_NE(d, nullptr);
  EXPECT_EQ(d->sample, -1);
}

TEST(SamplePlaces, WithoutMultisamplingThereIsSampleZeroAlone) {
  const Scene scene = covered_scene(1);
  const Rendering exact = rasterize(scene, {});
  Rendering rendered = exact;
  rendered.pixels[4 * rendered.pixel_index(1, 1)] ^= 0x80;
  rendered.fragments[0].color[0] -= 0.5;
  rendered.fragments.pop_back();
  const Result result = compare(scene, {}, exact, rendered, {8, nullptr});
  ASSERT_GE(result.disagreements.size(), 3U);
  for (const Disagreement& d : result.disagreements) EXPECT_EQ(d.sample, 0) << d.rule;
}

}  // namespace
}  // namespace edgecase
