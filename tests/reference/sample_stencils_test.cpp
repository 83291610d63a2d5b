// SPDX-License-Identifier: MIT
//
// Fragment operations on multisampled targets: each sample has its own stencil, depth and colour.
#include <gmock/gmock.h>

#include <bit>

#include "tests/reference/multisampled_scenes.h"
#include "tests/reference/operation_scenes.h"

namespace edgecase {
namespace {

using ::testing::Each;

class SampleStencilsTest : public MultisampleTest {
 protected:
  Scene stenciled(int width, int height, DepthFormat depth) const {
    Scene scene = sampled(width, height);
    scene.viewport = {0, 0, 16, 16};
    scene.target.depth = depth;
    scene.target.stencil = StencilFormat::stencil8;
    return scene;
  }

  // As `drawn`; none also where a pair of formats is known to be missing.
  std::optional<Rendering> with_stencils(const Scene& scene) {
    if (has_samples() && name() == "egl:zink-swiftshader" &&
        scene.target.depth == DepthFormat::depth24) {
      EXPECT_EQ(refusal_of(scene).substr(0, 32), "asked for depth24 and stencil8, ");
      return std::nullopt;
    }
    return drawn(scene);
  }
};

constexpr DepthFormat kFormats[] = {DepthFormat::none, DepthFormat::depth24, DepthFormat::depth32f};

StencilTest counting() {
  StencilFace face;
  face.pass = StencilOperation::incr;
  face.depth_fail = StencilOperation::invert;
  return {face, face};
}

TEST_P(SampleStencilsTest, EachSampleHasItsOwn) {
  for (DepthFormat format : kFormats) {
    Scene scene = stenciled(8, 8, format);
    scene.target.clear_stencil = 0x40;
    scene.draws = {make_draw(Primitive::triangles, {{100, 50}, {1900, 400}, {700, 1800}}),
                   make_draw(Primitive::triangles, {{300, 350}, {1700, 100}, {1100, 1500}})};
    for (Draw& draw : scene.draws) draw.operations.stencil = counting();
    const auto rendering = with_stencils(scene);
    if (!rendering) continue;
    ASSERT_EQ(rendering->stencils.size(), 4 * 64u) << name_of(format);
    std::vector<int> expected(4 * 64u, 0x40);
    for (const Fragment& fragment : rendering->fragments)
      for (int sample = 0; sample < 4; ++sample)
        expected[rendering->sample_index(fragment.x, fragment.y, sample)] +=
            static_cast<int>(fragment.coverage >> sample & 1);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(rendering->stencils[i], expected[i]) << name_of(format) << ' ' << i;
      EXPECT_EQ(static_cast<int>(rendering->hits[i]), expected[i] - 0x40);
    }
  }
}

TEST_P(SampleStencilsTest, MasksChooseTheSamplesThatAreWritten) {
  for (DepthFormat format : kFormats) {
    Scene scene = stenciled(3, 2, format);
    for (std::uint32_t sample = 0; sample < 4; ++sample) {
      scene.draws.push_back(flat_rectangle(0, 0, 3, 2, 0));
      StencilFace face;
      face.pass = StencilOperation::replace;
      face.reference = static_cast<std::uint8_t>(0x91 + sample * 29);
      scene.draws.back().operations.stencil = StencilTest{face, face};
      scene.draws.back().multisampling.mask = 1u << sample;
    }
    const auto rendering = with_stencils(scene);
    if (!rendering) continue;
    for (int sample = 0; sample < 4; ++sample)
      for (int x = 0; x < 3; ++x)
        EXPECT_EQ(rendering->stencils[rendering->sample_index(x, 1, sample)], 0x91 + sample * 29);
  }
}

// A plane that rises to the right, and one at the depth of the middle: each sample decides for
// itself.
TEST_P(SampleStencilsTest, TheDepthTestIsEachSamplesOwn) {
  for (DepthFormat format : {DepthFormat::depth24, DepthFormat::depth32f}) {
    Scene scene = stenciled(8, 1, format);
    scene.draws = {flat_rectangle(0, 0, 8, 1, 0), rectangle(0, 0, 8 * 256, 256, {0, 1, 0, 1})};
    for (Vertex& vertex : scene.draws[1].vertices)
      vertex.z = Fixed::from_integer(vertex.position.x.raw() > 0 ? 1 : -1);
    scene.draws[1].operations.stencil = counting();
    scene.draws[1].operations.depth.function = CompareFunction::less;
    const auto rendering = with_stencils(scene);
    if (!rendering) continue;
    int passed = 0;
    for (std::size_t i = 0; i < rendering->depths.size(); ++i) {
      const bool passes = rendering->depths[i] < 0.4999;
      passed += passes ? 1 : 0;
      EXPECT_EQ(rendering->stencils[i], passes ? 1 : 255);
      EXPECT_EQ(rendering->hits[i], passes ? 2u : 1u);
      EXPECT_EQ(rendering->sample_pixels[4 * i], passes ? 0 : 255);
    }
    EXPECT_EQ(passed, 16);
    // Each rectangle covers each sample once, whatever passes.
    int covered = 0;
    for (const Fragment& fragment : rendering->fragments)
      covered += std::popcount(fragment.coverage);
    EXPECT_EQ(covered, 64);
  }
}

TEST_P(SampleStencilsTest, BlendingIsEachSamplesOwn) {
  Scene scene = sampled(2, 1);
  scene.viewport = {0, 0, 16, 16};
  scene.target.clear = {0, 0, 0, 0};
  for (std::uint32_t mask : {0x3u, 0x6u}) {
    scene.draws.push_back(flat_rectangle(0, 0, 2, 1, 0, {0.4f, 0, 0, 0.2f}));
    scene.draws.back().multisampling.mask = mask;
    scene.draws.back().operations.blending =
        Blending{{BlendEquation::add, BlendFactor::one, BlendFactor::one},
                 {BlendEquation::add, BlendFactor::one, BlendFactor::one},
                 {}};
    scene.draws.back().operations.color_mask = {true, true, true, false};
  }
  const auto rendering = drawn(scene);
  if (!rendering) return;
  const int reds[] = {102, 204, 102, 0};
  for (int sample = 0; sample < 4; ++sample)
    EXPECT_THAT(sample_pixel(*rendering, 1, 0, sample),
                testing::ElementsAre(reds[sample], 0, 0, 0));
}

TEST_P(SampleStencilsTest, ManySamplesAndSizesAreReadInWhole) {
  for (int size : {1, 5, 33, 64}) {
    Scene scene = stenciled(size, 65 - size, DepthFormat::none);
    scene.viewport = {0, 0, 64, 64};
    scene.draws = {flat_rectangle(0, 0, 64, 64, 0)};
    scene.draws[0].operations.stencil = counting();
    const auto rendering = with_stencils(scene);
    if (!rendering) return;
    EXPECT_EQ(rendering->stencils.size(), 4 * static_cast<std::size_t>(size * (65 - size)));
    EXPECT_THAT(rendering->stencils, Each(1));
  }
}

INSTANTIATE_TEST_SUITE_P(OpenGl, SampleStencilsTest, EDGECASE_ALL_FRAMEBUFFER_OBJECTS, place_name);

}  // namespace
}  // namespace edgecase
