// SPDX-License-Identifier: MIT
//
// What the fragments of multisampled targets carry and where they write it: invocations, attributes
// where the rules have them, alpha to coverage, planes and resolved pixels.
#include <gtest/gtest.h>

#include <cmath>

#include "raster/samples.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

Rendering drawn(const Scene& scene, const Choices& rules = {}) {
  Policy policy;
  policy.rules = rules;
  return rasterize(scene, policy);
}

// A triangle left of x = 1.5 on a target of 2 by 2 pixels, red and depth as the window's x / 8: of
// column 1 samples 0 and 2 are covered, the centre is not.
Scene ramp() {
  Scene scene =
      multisampled_scene(2, 4, Primitive::triangles, {at(1.5, -8), at(1.5, 24), at(-6.5, 8)});
  Draw& draw = scene.draws[0];
  draw.interpolation = Interpolation::smooth;
  scene.target.depth = DepthFormat::depth32f;
  scene.details.coordinates = true;
  for (Vertex& vertex : draw.vertices) {
    const auto x = static_cast<float>(vertex.position.x.to_double());
    vertex.color = {x / 8, 0, 0, 1};
    vertex.z = Fixed::from_raw(vertex.position.x.raw() / 8);
  }
  return scene;
}

// Values are a few units of double precision off.
double rounded(double place) {
  return std::round(place * 65536) / 65536;
}

// Red, in pixels, of the fragments of the pixel.
std::vector<double> places(const Rendering& rendering, int x, int y) {
  std::vector<double> found;
  for (const Fragment& fragment : rendering.fragments)
    if (fragment.x == x && fragment.y == y) found.push_back(rounded(fragment.color[0] * 8));
  return found;
}

double depth_place(const Rendering& rendering, int x, int y, int sample) {
  return rounded((2 * rendering.depths[rendering.sample_index(x, y, sample)] - 1) * 8);
}

using Places = std::vector<double>;

TEST(MultisamplePlanes, AttributesAreThoseOfTheCentre) {
  const Rendering rendering = drawn(ramp());
  ASSERT_EQ(rendering.fragments.size(), 4u);
  EXPECT_EQ(rendering.fragments[0].coverage, 15u);
  EXPECT_EQ(rendering.fragments[1].coverage, 5u);
  EXPECT_EQ(places(rendering, 0, 0), Places{0.5});
  EXPECT_EQ(places(rendering, 1, 1), Places{1.5});
  const FragmentDetail& detail =
      rendering.details.at(static_cast<std::size_t>(rendering.fragments[1].detail));
  EXPECT_EQ(detail.coordinates, (std::array<double, 4>{1.5, 0.5, 0.59375, 1}));
  EXPECT_EQ(rendering.fragments[1].depth, 0.59375);
  EXPECT_EQ(rendering.sample_positions, standard_pattern(4));
}

TEST(MultisamplePlanes, CentroidIsACoveredSampleWhereSomeAreNot) {
  Scene scene = ramp();
  scene.draws[0].multisampling.location = AttributeLocation::centroid;
  const auto at_pixels = [&](const char* choice) {
    const Rendering rendering = drawn(scene, {{"attribute.centroid", choice}});
    return std::pair{places(rendering, 0, 0), places(rendering, 1, 0)};
  };
  EXPECT_EQ(at_pixels("centre-or-first"), (std::pair{Places{0.5}, Places{1.375}}));
  EXPECT_EQ(at_pixels("first-covered"), (std::pair{Places{0.375}, Places{1.375}}));
  EXPECT_EQ(at_pixels("mean-covered"), (std::pair{Places{0.5}, Places{1.25}}));
  EXPECT_EQ(at_pixels("centre"), (std::pair{Places{0.5}, Places{1.5}}));
  // gl_FragCoord keeps to the centre.
  EXPECT_EQ(drawn(scene).details.at(1).coordinates.value()[0], 1.5);
}

TEST(MultisamplePlanes, TheSampleQualifierMakesAnInvocationForEachCoveredSample) {
  Scene scene = ramp();
  scene.draws[0].multisampling.location = AttributeLocation::sample;
  const Rendering rendering = drawn(scene);
  ASSERT_EQ(rendering.fragments.size(), 12u);
  EXPECT_EQ(places(rendering, 0, 0), (Places{0.375, 0.875, 0.125, 0.625}));
  EXPECT_EQ(places(rendering, 1, 0), (Places{1.375, 1.125}));
  EXPECT_EQ(rendering.fragments[4].coverage, 1u);
  EXPECT_EQ(rendering.fragments[5].coverage, 4u);
  EXPECT_EQ(
      rendering.details.at(static_cast<std::size_t>(rendering.fragments[5].detail)).coordinates,
      (std::array<double, 4>{1.125, 0.625, 0.5703125, 1}));
  EXPECT_EQ(drawn(scene, {{"sample.shading-rate", "per-pixel"}}).fragments.size(), 4u);
}

TEST(MultisamplePlanes, SampleShadingAsksForInvocations) {
  Scene scene = ramp();
  for (const auto& [share, count] : {std::pair{0.0F, 4u}, {0.25F, 4u}, {0.3F, 12u}, {1.0F, 12u}}) {
    scene.draws[0].multisampling.min_sample_shading = share;
    EXPECT_EQ(drawn(scene).fragments.size(), count) << share;
  }
  EXPECT_EQ(places(drawn(scene), 1, 0), (Places{1.375, 1.125}));
  scene.draws[0].multisampling.enabled = false;
  EXPECT_EQ(drawn(scene).fragments.size(), 2u);
  EXPECT_EQ(drawn(scene, {{"sample.enable", "ignored"}}).fragments.size(), 12u);
  EXPECT_EQ(drawn(ramp(), {{"sample.shading-rate", "per-sample"}}).fragments.size(), 12u);
}

TEST(MultisamplePlanes, DepthIsThatOfEachSample) {
  const Rendering rendering = drawn(ramp());
  EXPECT_EQ(depth_place(rendering, 0, 1, 0), 0.375);
  EXPECT_EQ(depth_place(rendering, 0, 1, 1), 0.875);
  EXPECT_EQ(depth_place(rendering, 1, 1, 2), 1.125);
  EXPECT_EQ(rendering.depths[rendering.sample_index(1, 1, 1)], 1);  // not covered
  const auto place_under = [&](const char* choice, int sample) {
    return depth_place(drawn(ramp(), {{"sample.depth", choice}}), 0, 1, sample);
  };
  EXPECT_EQ(place_under("centre", 1), 0.5);
  EXPECT_EQ(place_under("mirrored-x", 1), 0.125);
  EXPECT_EQ(place_under("half-pixel-off", 1), 0.875);  // of triangles nothing is off
  EXPECT_EQ(drawn(ramp(), {{"sample.depth", "mirrored-x"}}).fragments[0].depth, 0.5390625);
}

TEST(MultisamplePlanes, DepthMayBeZeroWithoutSample0) {
  Scene scene = ramp();
  scene.draws[0].multisampling.mask = 0b1110;
  const Rendering rendering = drawn(scene, {{"sample.depth", "mirrored-x-or-zero"}});
  EXPECT_EQ(rendering.fragments[0].depth, 0);
  EXPECT_EQ(rendering.details.at(0).coordinates.value()[2], 0);
  EXPECT_EQ(depth_place(rendering, 0, 0, 1), 0.125);
}

TEST(MultisamplePlanes, WithoutMultisamplingSample0AloneMayHaveADepth) {
  Scene scene = ramp();
  scene.draws[0].multisampling.enabled = false;
  const Rendering rendering = drawn(scene, {{"sample.enable", "depth-of-first"}});
  EXPECT_EQ(depth_place(rendering, 0, 0, 0), 0.5);
  for (int s = 1; s < 4; ++s) EXPECT_EQ(rendering.depths[rendering.sample_index(0, 0, s)], 1);
  EXPECT_EQ(rendering.hits[rendering.sample_index(0, 0, 3)], 1u);
}

TEST(MultisamplePlanes, LinesMayBeHalfAPixelOff) {
  Scene scene = multisampled_scene(4, 4, Primitive::lines, {at(0, 1.5), at(4, 1.5)});
  scene.draws[0].interpolation = Interpolation::smooth;
  scene.draws[0].vertices[0].color = {0, 0, 0, 1};
  scene.draws[0].vertices[1].color = {0.5, 0, 0, 1};
  EXPECT_EQ(places(drawn(scene), 3, 1), Places{3.5});
  EXPECT_EQ(places(drawn(scene, {{"attribute.location", "half-pixel-off"}}), 3, 1), Places{4});
  EXPECT_EQ(places(drawn(scene, {{"attribute.location", "first-covered"}}), 3, 1), Places{3.375});
}

TEST(MultisamplePlanes, FragmentsWriteTheirSamplesAlone) {
  const Rendering rendering = drawn(ramp());
  ASSERT_EQ(rendering.hits.size(), 16u);
  ASSERT_EQ(rendering.sample_pixels.size(), 64u);
  for (int y : {0, 1})
    for (int s = 0; s < 4; ++s) {
      EXPECT_EQ(rendering.hits[rendering.sample_index(0, y, s)], 1u);
      EXPECT_EQ(rendering.hits[rendering.sample_index(1, y, s)], s % 2 == 0 ? 1u : 0u);
      const std::uint8_t red = rendering.sample_pixels[4 * rendering.sample_index(1, y, s)];
      EXPECT_EQ(red, s % 2 == 0 ? to_unorm8(1.5 / 8) : 0);
    }
  // 48 of two samples and 0 of the others; alpha is 255 everywhere.
  EXPECT_EQ(rendering.pixels[4], 24);
  EXPECT_EQ(rendering.pixels[7], 255);
}

TEST(MultisamplePlanes, AlphaIsWrittenAsItIs) {
  Scene scene = ramp();
  for (Vertex& vertex : scene.draws[0].vertices) vertex.color[3] = 0.2F;
  const Rendering rendering = drawn(scene);
  EXPECT_EQ(rendering.sample_pixels[4 * rendering.sample_index(0, 0, 1) + 3], 51);
  EXPECT_EQ(rendering.pixels[3], 51);
}

TEST(MultisamplePlanes, ManySamplesMakeOneFragmentOfAPixel) {
  const Rendering rendering =
      drawn(multisampled_scene(3, 16, Primitive::triangles, {at(-9, -9), at(2, -9), at(2, 13)}));
  ASSERT_EQ(rendering.fragments.size(), 6u);
  for (const Fragment& fragment : rendering.fragments) EXPECT_EQ(fragment.coverage, 0xffffu);
}

TEST(MultisamplePlanes, ResolvedByTheMethodOfThePolicy) {
  // Samples 0 and 2 hold 1 of 255: the mean is 1/2.
  Scene scene = ramp();
  scene.draws[0].interpolation = Interpolation::flat;
  for (Vertex& vertex : scene.draws[0].vertices) vertex.color = {1.0F / 255, 0, 0, 1};
  const auto red = [&](const char* method) {
    return static_cast<int>(drawn(scene, {{"sample.resolve", method}}).pixels[4]);
  };
  EXPECT_EQ(red("nearest-even"), 0);
  EXPECT_EQ(red("half-up"), 1);
  EXPECT_EQ(red("truncated"), 0);
  EXPECT_EQ(red("half-up-by-pairs"), 1);
  EXPECT_EQ(red("first-sample"), 1);
}

TEST(MultisamplePlanes, WithoutMultisamplingAllSamplesAreWritten) {
  Scene scene = ramp();
  Multisampling& use = scene.draws[0].multisampling;
  use.enabled = false;
  use.mask = 0;
  use.alpha_to_coverage = true;
  use.location = AttributeLocation::sample;
  for (Vertex& vertex : scene.draws[0].vertices) vertex.color[3] = 0;
  const Rendering rendering = drawn(scene);
  ASSERT_EQ(rendering.fragments.size(), 2u);  // the right edge runs through the centres of column 1
  EXPECT_EQ(rendering.fragments[0].coverage, 1u);
  EXPECT_EQ(places(rendering, 0, 0), Places{0.5});
  for (int s = 0; s < 4; ++s) {
    EXPECT_EQ(rendering.hits[rendering.sample_index(0, 0, s)], 1u);
    EXPECT_EQ(depth_place(rendering, 0, 0, s), 0.5);
    EXPECT_EQ(rendering.hits[rendering.sample_index(1, 0, s)], 0u);
  }
}

TEST(MultisamplePlanes, AlphaToCoverageKeepsSamplesAndCoverageTellsNothingOfIt) {
  Scene scene = ramp();
  scene.draws[0].multisampling.alpha_to_coverage = true;
  for (Vertex& vertex : scene.draws[0].vertices) vertex.color[3] = 0.5F;
  const auto written = [&](const Choices& rules) {
    const Rendering rendering = drawn(scene, rules);
    EXPECT_EQ(rendering.fragments.at(0).coverage, 15u);
    std::uint32_t mask = 0;
    for (int s = 0; s < 4; ++s) mask |= rendering.hits[rendering.sample_index(0, 0, s)] << s;
    return mask;
  };
  EXPECT_EQ(written({}), 3u);
  EXPECT_EQ(written({{"sample.alpha-to-coverage", "ignored"}}), 15u);
  EXPECT_EQ(drawn(scene).depths[drawn(scene).sample_index(0, 0, 2)], 1);
  // Per sample each invocation's alpha counts for its own sample: alpha as red, x / 8.
  scene.draws[0].multisampling.location = AttributeLocation::sample;
  for (Vertex& vertex : scene.draws[0].vertices) vertex.color[3] = vertex.color[0] * 4;
  const Rendering rendering = drawn(scene);
  // x / 2 of 3/16, 7/16, 1/16 and 5/16 against 1/8, 3/8, 5/8 and 7/8.
  for (int s = 0; s < 4; ++s)
    EXPECT_EQ(rendering.hits[rendering.sample_index(0, 0, s)], s < 2 ? 1u : 0u) << s;
}

TEST(MultisamplePlanes, SamplesMayHeedTheAlphasOfOthers) {
  Scene scene = ramp();
  Multisampling& use = scene.draws[0].multisampling;
  use.alpha_to_coverage = true;
  use.location = AttributeLocation::sample;
  for (Vertex& vertex : scene.draws[0].vertices)
    vertex.color = {0, 0, 0, static_cast<float>(vertex.position.x.to_double())};
  const ScenePrimitive primitive = primitives_of(scene).at(0);
  const PrimitiveAttributes attributes =
      attributes_of(primitive, resolve({}, Surface::fbo), scene.target);
  Places alphas = alphas_of_samples(primitive, attributes, {0, 0}, standard_pattern(4), {});
  for (double& alpha : alphas) alpha = rounded(alpha);
  EXPECT_EQ(alphas, (Places{0.375, 0.875, 0.125, 0.625}));
  // Above s/4 for the samples 0 and 1, all, 0, and 0 to 2: sample 2 clears 1 and 3, and 0 stops 2.
  const Rendering rendering =
      drawn(scene, {{"sample.alpha-to-coverage", "above-quotient-of-others"}});
  EXPECT_EQ(places(rendering, 0, 0).size(), 2u);
  for (int s = 0; s < 4; ++s)
    EXPECT_EQ(rendering.hits[rendering.sample_index(0, 0, s)], s == 0 ? 1u : 0u) << s;
}

TEST(MultisamplePlanes, LaterPrimitivesOverwriteSampleBySample) {
  Scene scene = ramp();
  scene.draws.push_back(scene.draws[0]);
  scene.draws[1].multisampling.mask = 0b0001;
  scene.draws[1].interpolation = Interpolation::flat;
  for (Vertex& vertex : scene.draws[1].vertices) vertex.color = {0, 1, 0, 1};
  const Rendering rendering = drawn(scene);
  const auto green = [&](int s) {
    return rendering.sample_pixels[4 * rendering.sample_index(0, 0, s) + 1];
  };
  EXPECT_EQ(green(0), 255);
  EXPECT_EQ(green(1), 0);
  EXPECT_EQ(rendering.hits[rendering.sample_index(0, 0, 0)], 2u);
  EXPECT_EQ(rendering.pixels[1], 64);  // 63.75
}

}  // namespace
}  // namespace edgecase
