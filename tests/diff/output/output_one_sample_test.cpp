// SPDX-License-Identifier: MIT
//
// Without GL_MULTISAMPLE, depth and stencil tests may be those of one sample for all samples of the
// pixel (ruling 35; GL 4.6 core, 17.3.10).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <string>

#include "diff/output/test_of_one_sample.h"
#include "tests/diff/output/output_judging.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

constexpr int kSize = 4;

Draw left_of(double right, Fixed z, const Color& color) {
  Draw draw = multisampled_scene(kSize, 4, Primitive::triangles,
                                 {at(0, 0), at(right, 0), at(right, kSize), at(0, 0),
                                  at(right, kSize), at(0, kSize)})
                  .draws.front();
  for (Vertex& vertex : draw.vertices) {
    vertex.z = z;
    vertex.color = color;
  }
  return draw;
}

// In column 2, samples 0 and 2 hold the near depth of a first draw, and samples 1 and 3 the clear
// value. The second draw, farther away, is without GL_MULTISAMPLE.
Scene half_hidden_column() {
  Scene scene = multisampled_scene(kSize, 4, Primitive::triangles, {});
  scene.target.depth = DepthFormat::depth24;
  scene.draws = {left_of(2.5, Fixed::from_raw(-Fixed::kOne / 2), {1, 0, 0, 1}),
                 left_of(3, Fixed(), {0, 1, 0, 1})};
  scene.draws[1].multisampling.enabled = false;
  scene.draws[1].operations.depth = {CompareFunction::less, true};
  return scene;
}

// Copies one sample of a pixel over another.
void copy_sample(Rendering& rendering, PixelPosition pixel, int from, int to) {
  const std::size_t source = rendering.sample_index(pixel.x, pixel.y, from);
  const std::size_t target = rendering.sample_index(pixel.x, pixel.y, to);
  std::copy_n(rendering.sample_pixels.begin() + static_cast<std::ptrdiff_t>(4 * source), 4,
              rendering.sample_pixels.begin() + static_cast<std::ptrdiff_t>(4 * target));
  rendering.depths[target] = rendering.depths[source];
  rendering.hits[target] = rendering.hits[source];
}

// Exact's rendering, in whose column 2 the second draw passes or fails as a whole in each row.
Rendering tested_as_a_whole(const Scene& scene, const std::function<bool(int row)>& passes) {
  Rendering rendering = rasterize(scene, {});
  Scene first_alone = scene;
  first_alone.draws.pop_back();
  const Rendering before = rasterize(first_alone, {});
  for (int row = 0; row < kSize; ++row)
    for (int sample = 0; sample < 4; ++sample) {
      const std::size_t at = rendering.sample_index(2, row, sample);
      const std::size_t green = rendering.sample_index(2, row, 1);
      if (passes(row)) {
        const std::uint32_t hits = before.hits[at] + 1;
        copy_sample(rendering, {2, row}, 1, sample);
        rendering.hits[at] = hits;
        rendering.depths[at] = rendering.depths[green];
      } else {
        std::copy_n(before.sample_pixels.begin() + static_cast<std::ptrdiff_t>(4 * at), 4,
                    rendering.sample_pixels.begin() + static_cast<std::ptrdiff_t>(4 * at));
        rendering.depths[at] = before.depths[at];
        rendering.hits[at] = before.hits[at];
      }
    }
  rendering.pixels.clear();
  return rendering;
}

TEST(TestOfOneSample, IsPermittedWhicheverSampleItIs) {
  const Scene scene = half_hidden_column();
  for (const bool passes : {false, true}) {
    const Result result =
        judge_output(scene, {}, tested_as_a_whole(scene, [&](int) { return passes; }));
    EXPECT_EQ(result.verdict, Verdict::permitted) << described(result);
    EXPECT_TRUE(result.disagreements.empty()) << described(result);
  }
}

TEST(TestOfOneSample, IsOfTheSameSampleInTheWholeCase) {
  const Scene scene = half_hidden_column();
  const Result result =
      judge_output(scene, {}, tested_as_a_whole(scene, [](int row) { return row < 2; }));
  EXPECT_EQ(result.verdict, Verdict::violation) << described(result);
}

TEST(TestOfOneSample, DoesNotExcuseOneSampleOfAPixel) {
  const Scene scene = half_hidden_column();
  Rendering rendering = tested_as_a_whole(scene, [](int) { return false; });
  // Sample 1 fails with sample 0, and sample 3 passes.
  const Rendering exact = rasterize(scene, {});
  const std::size_t at = rendering.sample_index(2, 1, 3);
  std::copy_n(exact.sample_pixels.begin() + static_cast<std::ptrdiff_t>(4 * at), 4,
              rendering.sample_pixels.begin() + static_cast<std::ptrdiff_t>(4 * at));
  rendering.depths[at] = exact.depths[at];
  rendering.hits[at] = exact.hits[at];
  EXPECT_EQ(judge_output(scene, {}, rendering).verdict, Verdict::violation);
}

TEST(TestOfOneSample, IsNotForDrawsWithMultisampling) {
  Scene scene = half_hidden_column();
  scene.draws[1].multisampling.enabled = true;
  scene.draws[1] = left_of(3, Fixed(), {0, 1, 0, 1});
  scene.draws[1].operations.depth = {CompareFunction::less, true};
  const Result result =
      judge_output(scene, {}, tested_as_a_whole(scene, [](int) { return false; }));
  EXPECT_EQ(result.verdict, Verdict::violation) << described(result);
}

// "all multisample buffer stencil sample values are set to the appropriate new stencil value".
TEST(TestOfOneSample, GivesAllSamplesTheNewStencilValue) {
  Scene scene = half_hidden_column();
  scene.target.depth = DepthFormat::none;
  scene.target.stencil = StencilFormat::stencil8;
  scene.draws.erase(scene.draws.begin());
  StencilTest increment;
  increment.front.pass = StencilOperation::incr;
  increment.back.pass = StencilOperation::incr;
  scene.draws[0].operations.stencil = increment;
  Rendering rendering = rasterize(scene, {});
  ASSERT_EQ(judge_output(scene, {}, rendering).verdict, Verdict::agree);
  for (int sample = 1; sample < 4; ++sample)
    rendering.stencils[rendering.sample_index(1, 1, sample)] = 0;
  EXPECT_EQ(judge_output(scene, {}, rendering).verdict, Verdict::violation);
}

}  // namespace
}  // namespace edgecase
