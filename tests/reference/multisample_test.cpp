// SPDX-License-Identifier: MIT
//
// Multisampled targets on real OpenGL: what is covered, written and told of each sample.
#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "tests/reference/multisampled_scenes.h"

namespace edgecase {
namespace {

using ::testing::AnyOf;
using ::testing::Each;
using ::testing::ElementsAre;

class SamplesTest : public MultisampleTest {};

// Twice the signed area of a triangle, in units of 2^-32 pixel squared.
std::int64_t turn(Point a, Point b, Point c) {
  return (b.x.raw() - a.x.raw()) * (c.y.raw() - a.y.raw()) -
         (b.y.raw() - a.y.raw()) * (c.x.raw() - a.x.raw());
}

// Which samples of a pixel lie in a triangle that turns left; none may lie on an edge.
std::uint32_t mask_within(const Draw& triangle, const SamplePositions& positions, int x, int y) {
  std::uint32_t mask = 0;
  for (std::size_t sample = 0; sample < positions.size(); ++sample) {
    const Point place = place_in({x, y}, positions[sample]);
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t side =
          turn(triangle.vertices[i].position, triangle.vertices[(i + 1) % 3].position, place);
      EXPECT_NE(side, 0);
      inside = inside && side > 0;
    }
    if (inside) mask |= 1u << sample;
  }
  return mask;
}

TEST_P(SamplesTest, AreWhereTheDriverSaysThatTheyAre) {
  for (bool upright : {false, true}) {
    for (int edge = 1; edge < 16; edge += 2) {
      Scene scene = sampled(1, 1);
      const int end = edge * 16;
      scene.draws = {rectangle(0, 0, upright ? 256 : end, upright ? end : 256)};
      const auto rendering = drawn(scene);
      if (!rendering) return;
      ASSERT_EQ(rendering->sample_positions.size(), 4u);
      std::uint32_t expected = 0;
      for (std::size_t sample = 0; sample < 4; ++sample) {
        const Point place = rendering->sample_positions[sample];
        if ((upright ? place.y : place.x).raw() * 16 < edge * Fixed::kOne) expected |= 1u << sample;
      }
      EXPECT_EQ(hit_mask(*rendering, 0, 0), expected) << edge;
    }
  }
}

TEST_P(SamplesTest, AreCoveredByTheTriangleThatContainsThem) {
  Scene scene = sampled(8, 8);
  scene.target.clear = {0, 0, 1, 1};
  // Multiples of 1/16, on which no sample is on an edge.
  scene.draws = {
      make_draw(Primitive::triangles, {{336, 272}, {1712, 560}, {752, 1744}}, {1, 0, 0, 1})};
  const auto rendering = drawn(scene);
  if (!rendering) return;
  auto masks = coverage_masks(*rendering);
  std::set<std::uint32_t> found;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const std::uint32_t expected = mask_within(scene.draws[0], rendering->sample_positions, x, y);
      const std::uint32_t mask = masks[{x, y}];
      found.insert(expected);
      EXPECT_EQ(mask, expected) << x << ", " << y;
      EXPECT_EQ(hit_mask(*rendering, x, y), expected);
      for (int sample = 0; sample < 4; ++sample) {
        const bool covered = (expected >> sample & 1) != 0;
        EXPECT_EQ(rendering->hits[rendering->sample_index(x, y, sample)], covered ? 1u : 0u);
        EXPECT_THAT(sample_pixel(*rendering, x, y, sample),
                    ElementsAre(covered ? 255 : 0, 0, covered ? 0 : 255, 255));
      }
    }
  }
  // Whole pixels, none, and many between.
  EXPECT_GE(found.size(), 8u);
  for (const Fragment& fragment : rendering->fragments) EXPECT_GT(fragment.coverage, 0u);
}

TEST_P(SamplesTest, ResolveToTheirMean) {
  Scene scene = sampled(2, 1);
  scene.draws = {rectangle(0, 0, 512, 256, {0.2f, 0.4f, 0.6f, 0.8f})};
  const auto constant = drawn(scene);
  if (!constant) return;
  EXPECT_THAT(pixel(*constant, 0, 0), ElementsAre(51, 102, 153, 204));
  EXPECT_THAT(pixel(*constant, 1, 0), ElementsAre(51, 102, 153, 204));
  for (int sample = 0; sample < 4; ++sample)
    EXPECT_THAT(sample_pixel(*constant, 1, 0, sample), ElementsAre(51, 102, 153, 204));
  // Half of the left pixel's samples are red.
  scene.draws = {rectangle(0, 0, 128, 256, {1, 0, 0, 1})};
  const auto half = drawn(scene);
  EXPECT_EQ(__builtin_popcount(hit_mask(*half, 0, 0)), 2);
  EXPECT_THAT(pixel(*half, 0, 0), ElementsAre(AnyOf(127, 128), 0, 0, 255));
  EXPECT_THAT(pixel(*half, 1, 0), ElementsAre(0, 0, 0, 255));
}

TEST_P(SamplesTest, OutsideTheMaskAreNotWritten) {
  Scene scene = sampled(4, 4);
  scene.draws = {rectangle(0, 0, 1024, 1024)};
  for (std::uint32_t mask = 0; mask < 16; ++mask) {
    scene.draws[0].multisampling.mask = mask;
    const auto rendering = drawn(scene);
    if (!rendering) return;
    EXPECT_EQ(coverage_masks(*rendering).size(), mask == 0 ? 0u : 16u);
    for (const auto& [place, covered] : coverage_masks(*rendering)) EXPECT_EQ(covered, mask);
    EXPECT_EQ(hit_mask(*rendering, 1, 2), mask);
    for (int sample = 0; sample < 4; ++sample)
      EXPECT_EQ(sample_pixel(*rendering, 1, 2, sample)[0], (mask >> sample & 1) != 0 ? 255 : 0);
  }
}

TEST_P(SamplesTest, AreWrittenInProportionToAlpha) {
  Scene scene = sampled(2, 2);
  for (const auto& [alpha, expected] : {std::pair(0.0f, 0), {0.5f, 2}, {1.0f, 4}}) {
    scene.draws = {rectangle(0, 0, 512, 512, {1, 1, 1, alpha})};
    scene.draws[0].multisampling.alpha_to_coverage = true;
    const auto rendering = drawn(scene);
    if (!rendering) return;
    for (const auto& [place, covered] : coverage_masks(*rendering)) EXPECT_EQ(covered, 15u);
    EXPECT_EQ(coverage_masks(*rendering).size(), 4u);
    const std::uint32_t written = hit_mask(*rendering, 0, 1);
    EXPECT_EQ(__builtin_popcount(written), expected) << alpha;
    // The pass for pixels writes what the pass for hits counts.
    for (int sample = 0; sample < 4; ++sample)
      EXPECT_EQ(sample_pixel(*rendering, 0, 1, sample)[0], (written >> sample & 1) != 0 ? 255 : 0);
  }
}

TEST_P(SamplesTest, AreAllWrittenWithoutMultisampling) {
  Scene scene = sampled(8, 4);
  scene.draws = {make_draw(Primitive::lines, {{300, 300}, {1700, 700}})};
  scene.draws[0].multisampling.enabled = false;
  scene.draws[0].multisampling.mask = 2;
  const auto rendering = drawn(scene);
  if (!rendering) return;
  Scene single = scene;
  single.target.samples = 1;
  single.draws[0].multisampling = {};
  const Rendering ordinary = render(renderer(), single);
  ASSERT_EQ(ordinary.hits.size(), 32u);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x)
      EXPECT_EQ(hit_mask(*rendering, x, y),
                ordinary.hits[ordinary.pixel_index(x, y)] > 0 ? 15u : 0u)
          << x << ", " << y;
  if (name().find("zink") != std::string::npos) return;  // ignores the switch for triangles
  // Its pixel's centre, and one sample; then one sample without the centre.
  scene.draws = {rectangle(112, 112, 256, 256), rectangle(512, 0, 512 + 112, 256)};
  for (Draw& draw : scene.draws) draw.multisampling.enabled = false;
  const auto triangles = drawn(scene);
  EXPECT_EQ(hit_mask(*triangles, 0, 0), 15u);
  EXPECT_EQ(hit_mask(*triangles, 2, 0), 0u);
  for (const Fragment& fragment : triangles->fragments) EXPECT_EQ(fragment.coverage, 1u);
}

// Red is the window's x over the width.
Scene ramp_along_x(Scene scene) {
  scene.draws = {make_draw(Primitive::triangles, {{16, 16}, {2000, 80}, {48, 2000}})};
  scene.draws[0].interpolation = Interpolation::smooth;
  for (Vertex& vertex : scene.draws[0].vertices)
    vertex.color = {static_cast<float>(vertex.position.x.to_double() / 8), 0, 0, 1};
  return scene;
}

TEST_P(SamplesTest, HaveInvocationsOfTheirOwnWhereAskedFor) {
  Scene scene = ramp_along_x(sampled(8, 8));
  scene.details.coordinates = true;
  const auto once = drawn(scene);
  if (!once) return;
  EXPECT_EQ(once->fragments.size(), coverage_masks(*once).size());
  Scene each = scene;
  each.draws[0].multisampling.min_sample_shading = 1.0f;
  Scene qualified = scene;
  qualified.draws[0].multisampling.location = AttributeLocation::sample;
  for (const Scene& shaded : {each, qualified}) {
    const auto rendering = drawn(shaded);
    EXPECT_EQ(coverage_masks(*rendering), coverage_masks(*once));
    EXPECT_EQ(rendering->hits, once->hits);
    for (const Fragment& fragment : rendering->fragments) {
      ASSERT_EQ(__builtin_popcount(fragment.coverage), 1);
      const auto sample = static_cast<std::size_t>(__builtin_ctz(fragment.coverage));
      const Point place = place_in({fragment.x, fragment.y}, rendering->sample_positions[sample]);
      EXPECT_NEAR(fragment.color[0] * 8, place.x.to_double(), 1e-3);
      const auto& coordinates =
          rendering->details[static_cast<std::size_t>(fragment.detail)].coordinates.value();
      EXPECT_NEAR(coordinates[0], place.x.to_double(), 1e-3);
      EXPECT_NEAR(coordinates[1], place.y.to_double(), 1e-3);
    }
  }
}

TEST_P(SamplesTest, ShareAnInvocationWhereNoneIsAskedFor) {
  for (AttributeLocation location : {AttributeLocation::center, AttributeLocation::centroid}) {
    Scene scene = ramp_along_x(sampled(8, 8));
    scene.draws[0].multisampling.location = location;
    scene.draws[0].multisampling.min_sample_shading = 0.0f;
    const auto rendering = drawn(scene);
    if (!rendering) return;
    ASSERT_EQ(rendering->fragments.size(), coverage_masks(*rendering).size());
    bool has_moved = false;
    for (const Fragment& fragment : rendering->fragments) {
      const double within = fragment.color[0] * 8 - fragment.x;
      EXPECT_GT(within, -1e-3);
      EXPECT_LT(within, 1 + 1e-3);
      if (fragment.coverage == 15 || location == AttributeLocation::center) {
        EXPECT_NEAR(within, 0.5, 1e-3);
      }
      has_moved = has_moved || std::abs(within - 0.5) > 0.05;
    }
    EXPECT_EQ(has_moved, location == AttributeLocation::centroid);
  }
}

INSTANTIATE_TEST_SUITE_P(OpenGl, SamplesTest, EDGECASE_ALL_FRAMEBUFFER_OBJECTS, place_name);

}  // namespace
}  // namespace edgecase
