// SPDX-License-Identifier: MIT
//
// Which multisampled targets real OpenGL has, what their depth buffers hold, and that they leave
// nothing to the next scene.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/reference/multisampled_scenes.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class MultisampleTargetTest : public MultisampleTest {
 protected:
  // True if Mesa's drivers that make 4 samples make 8, too.
  static bool make_eight() { return is_mesa("26."); }
};

TEST_P(MultisampleTargetTest, EveryPlaceHasTheSamplesThatItIsKnownToHave) {
  drawn(sampled(2, 2));
  if (name().starts_with("egl:device")) return;
  EXPECT_EQ(renderer().info().traits.at("samples"), !has_samples() ? "none"
                                                    : make_eight() ? "4 8"
                                                                   : "4");
}

TEST_P(MultisampleTargetTest, AnotherNumberOfSamplesIsRefused) {
  if (!has_samples() || name().starts_with("egl:device")) return;
  for (int samples : {2, 3, 8, 16}) {
    if (samples == 8 && make_eight()) continue;
    Scene scene = blank(8, 8);
    scene.target.samples = samples;
    EXPECT_EQ(refusal_of(scene), "asked for " + std::to_string(samples) +
                                     " samples, this driver makes " +
                                     (make_eight() ? "4, 8" : "4"));
  }
}

TEST_P(MultisampleTargetTest, WhatCannotBeHadIsRefusedWithAReason) {
  Scene window = sampled(4, 4);
  window.target.surface = Surface::window;
  EXPECT_EQ(refusal_of(window), "a window's samples cannot be chosen");
  if (!has_samples() || name().starts_with("egl:device")) return;
  Scene placed = sampled(4, 4);
  placed.target.sample_positions.assign(4, centre_of_pixel());
  // Mesa 26's llvmpipe has the extension, and its samples are found elsewhere.
  if (!is_mesa("26."))
    EXPECT_EQ(refusal_of(placed),
              "samples cannot be placed on this driver: it lacks GL_ARB_sample_locations");
  else
    EXPECT_THAT(refusal_of(placed), ::testing::AnyOf(HasSubstr("samples cannot be placed"),
                                                     HasSubstr("does not place the samples")));
  Scene line = sampled(4, 4);
  line.draws = {make_draw(Primitive::lines, {{0, 0}, {1024, 1024}})};
  line.draws[0].line_width = Fixed::from_raw(Fixed::kOne / 2);
  EXPECT_THAT(refusal_of(line), StartsWith("multisampled lines of width 0.5 are not drawn"));
  // The same width is rounded to 1 where a line is not multisampled.
  line.draws[0].multisampling.enabled = false;
  EXPECT_EQ(refusal_of(line), "");
}

// A row of pixels, each wholly covered at a depth of its own.
Scene steps_of_depth(Scene scene) {
  scene.viewport = {0, 0, 64, 1};
  for (int i = 0; i < 64; ++i) {
    scene.draws.push_back(rectangle(i * 256, 0, i * 256 + 256, 256));
    for (Vertex& vertex : scene.draws.back().vertices)
      vertex.z = Fixed::from_raw(i == 63 ? Fixed::kOne : (i - 32) * 2048 + 77 * i);
  }
  return scene;
}

TEST_P(MultisampleTargetTest, SamplesHoldTheDepthsThatOneSampleHolds) {
  for (DepthFormat format : {DepthFormat::depth16, DepthFormat::depth24, DepthFormat::depth32f}) {
    Scene scene = steps_of_depth(blank(66, 1));
    scene.target.depth = format;
    const Outcome single = render_outcome(renderer(), scene);
    scene.target.samples = kSamples;
    if (const auto* failure = std::get_if<Failure>(&single)) {
      EXPECT_EQ(refusal_of(scene), failure->reason) << name_of(format);
      continue;
    }
    const auto rendering = drawn(scene);
    if (!rendering) return;
    const std::vector<double>& expected = std::get<Rendering>(single).depths;
    ASSERT_EQ(expected.size(), 66u);
    ASSERT_EQ(rendering->depths.size(), 4 * 66u);
    for (std::size_t i = 0; i < rendering->depths.size(); ++i)
      EXPECT_EQ(rendering->depths[i], expected[i % 66]) << name_of(format) << ' ' << i;
  }
}

TEST_P(MultisampleTargetTest, EachSampleHasTheDepthAtItsOwnPlace) {
  Scene scene = sampled(8, 8);
  scene.target.depth = DepthFormat::depth32f;
  scene.draws = {rectangle(0, 0, 8 * 256, 8 * 256)};
  for (Vertex& vertex : scene.draws[0].vertices)
    vertex.z = Fixed::from_integer(vertex.position.y.raw() > 0 ? 1 : -1);
  const auto rendering = drawn(scene);
  if (!rendering) return;
  for (int sample = 0; sample < 4; ++sample) {
    const Point place = rendering->sample_positions[static_cast<std::size_t>(sample)];
    for (int y = 0; y < 8; ++y)
      EXPECT_NEAR(rendering->depths[rendering->sample_index(3, y, sample)],
                  (y + place.y.to_double()) / 8, 1e-6);
  }
}

Scene busy(Scene scene) {
  scene.draws = {make_draw(Primitive::triangles, {{100, 50}, {1900, 400}, {700, 1800}}),
                 make_draw(Primitive::line_strip, {{30, 30}, {1500, 700}, {900, 1700}}),
                 make_draw(Primitive::points, {{640, 640}})};
  scene.draws[0].interpolation = Interpolation::smooth;
  scene.draws[0].vertices[1].color = {1, 0, 0, 0.25f};
  return scene;
}

void expect_same(const Rendering& a, const Rendering& b) {
  EXPECT_EQ(a.pixels, b.pixels);
  EXPECT_EQ(a.sample_pixels, b.sample_pixels);
  EXPECT_EQ(a.hits, b.hits);
  EXPECT_EQ(a.depths, b.depths);
  ASSERT_EQ(a.fragments.size(), b.fragments.size());
  for (std::size_t i = 0; i < a.fragments.size(); ++i) {
    EXPECT_FALSE(precedes(a.fragments[i], b.fragments[i]) ||
                 precedes(b.fragments[i], a.fragments[i]));
    EXPECT_EQ(a.fragments[i].color, b.fragments[i].color);
    EXPECT_EQ(a.fragments[i].depth, b.fragments[i].depth);
  }
}

TEST_P(MultisampleTargetTest, NothingIsLeftToTheNextScene) {
  Scene single = busy(blank(8, 8));
  single.target.depth = DepthFormat::depth16;
  Scene plain = busy(sampled(8, 8));
  Scene odd = busy(sampled(8, 8));
  odd.target.depth = DepthFormat::depth16;
  odd.draws[0].multisampling = {true, AttributeLocation::sample, 1.0f, 2, true};
  odd.draws[1].multisampling.enabled = false;
  odd.draws[2].multisampling = {true, AttributeLocation::centroid, std::nullopt, 5, true};
  const Rendering single_before = render(renderer(), single);
  const auto plain_before = drawn(plain);
  if (!plain_before) return;
  const auto odd_before = drawn(odd);
  expect_same(render(renderer(), single), single_before);
  expect_same(*drawn(plain), *plain_before);
  expect_same(*drawn(odd), *odd_before);
  // Nor by a scene that is refused.
  Scene refused = odd;
  refused.target.samples = 3;
  EXPECT_NE(refusal_of(refused), "");
  expect_same(render(renderer(), single), single_before);
  // A single-sampled scene has one sample's worth of everything.
  EXPECT_TRUE(single_before.sample_pixels.empty() && single_before.sample_positions.empty());
  EXPECT_EQ(single_before.hits.size(), 64u);
}

TEST_P(MultisampleTargetTest, ManySizesOneAfterTheOther) {
  for (int size = 1; size <= 40; ++size) {
    Scene scene = sampled(size, 41 - size);
    scene.viewport = {0, 0, 64, 64};
    scene.draws = {rectangle(0, 0, 50 * 256, 50 * 256)};
    const auto rendering = drawn(scene);
    if (!rendering) return;
    EXPECT_EQ(coverage_masks(*rendering).size(), static_cast<std::size_t>(size * (41 - size)));
    EXPECT_THAT(rendering->hits, testing::Each(1u));
  }
}

INSTANTIATE_TEST_SUITE_P(OpenGl, MultisampleTargetTest, EDGECASE_ALL_FRAMEBUFFER_OBJECTS,
                         place_name);

}  // namespace
}  // namespace edgecase
