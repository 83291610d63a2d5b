// SPDX-License-Identifier: MIT
//
// Depth buffers on the OpenGL side: what is drawn last is what they hold, in their own format.
#include <gmock/gmock.h>

#include <cmath>
#include <optional>

#include "tests/reference/opengl_test.h"

namespace edgecase {
namespace {

using ::testing::AnyOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr DepthFormat kFormats[] = {DepthFormat::depth16, DepthFormat::depth24,
                                    DepthFormat::depth32f};

double largest_of(DepthFormat format) {
  return format == DepthFormat::depth16 ? 65535 : 16777215;
}

class DepthTest : public OpenGlTest {
 protected:
  // A scene with this depth buffer, or none where the place refuses it for a reason that names it.
  std::optional<Rendering> rendering_with(Scene scene, DepthFormat format) {
    scene.target.depth = format;
    Outcome outcome = render_outcome(renderer(), scene);
    const auto* failure = std::get_if<Failure>(&outcome);
    if (failure == nullptr) return std::get<Rendering>(std::move(outcome));
    EXPECT_EQ(failure->kind, FailureKind::unsupported);
    const std::string name = name_of(format);
    EXPECT_THAT(failure->reason,
                AnyOf(StartsWith("the window-system framebuffer is not " + name + ": it"),
                      StartsWith("asked for " + name + ", this driver makes another")));
    return std::nullopt;
  }
};

// A row of 256 points over all depths.
Scene points_of_all_depths(Scene scene) {
  scene.viewport = {0, 0, 256, 1};
  for (int i = 0; i < 256; ++i) {
    scene.draws.push_back(make_draw(Primitive::points, {{i * 256 + 128, 128}}));
    scene.draws[static_cast<std::size_t>(i)].vertices[0].z = Fixed::from_raw((i - 128) * 512 + 77);
  }
  return scene;
}

TEST_P(DepthTest, HoldsFragmentsDepthsInItsOwnFormat) {
  const Scene scene = points_of_all_depths(blank(256, 1));
  for (DepthFormat format : kFormats) {
    const auto rendering = rendering_with(scene, format);
    if (!rendering) continue;
    ASSERT_EQ(rendering->depths.size(), 256u) << name_of(format);
    ASSERT_EQ(rendering->fragments.size(), 256u);
    for (std::size_t i = 0; i < 256; ++i) {
      const double depth = rendering->fragments[i].depth;
      if (format == DepthFormat::depth32f) {
        EXPECT_EQ(rendering->depths[i], depth);
        continue;
      }
      const double stored = rendering->depths[i] * largest_of(format);
      EXPECT_EQ(rendering->depths[i], std::round(stored) / largest_of(format));
      EXPECT_LE(std::abs(stored - depth * largest_of(format)), 1.0) << name_of(format);
    }
  }
}

TEST_P(DepthTest, IsTheLastFragmentsWhateverItsDepth) {
  Scene scene = blank(4, 4);
  scene.viewport = {0, 0, 8, 8};
  scene.draws = {rectangle(0, 0, 3 * 256, 3 * 256, {1, 0, 0, 1}),
                 rectangle(256, 256, 8 * 256, 8 * 256, {0, 1, 0, 1})};
  for (Vertex& vertex : scene.draws[0].vertices) vertex.z = Fixed::from_integer(-1);
  for (DepthFormat format : kFormats) {
    const auto rendering = rendering_with(scene, format);
    if (!rendering) continue;
    const auto depth = [&](int x, int y) {
      return rendering->depths[rendering->pixel_index(x, y)];
    };
    EXPECT_EQ(depth(0, 0), 0);
    EXPECT_EQ(depth(0, 2), 0);
    EXPECT_EQ(depth(0, 3), 1);
    EXPECT_EQ(depth(3, 0), 1);
    EXPECT_NEAR(depth(1, 1), 0.5, 1.0 / 65535);
    EXPECT_NEAR(depth(3, 3), 0.5, 1.0 / 65535);
    EXPECT_THAT(pixel(*rendering, 1, 1), testing::ElementsAre(0, 255, 0, 255));
  }
}

TEST_P(DepthTest, ChangesNothingElse) {
  Scene scene = blank(16, 16);
  scene.draws = {make_draw(Primitive::triangles, {{100, 50}, {3900, 400}, {700, 3800}}),
                 make_draw(Primitive::line_strip, {{30, 30}, {2500, 1700}, {900, 3700}})};
  scene.draws[0].interpolation = Interpolation::smooth;
  scene.draws[0].vertices[1].color = {1, 0, 0, 1};
  scene.draws[0].vertices[2].z = Fixed::from_integer(1);
  const Rendering without = render(renderer(), scene);
  EXPECT_TRUE(without.depths.empty());
  for (DepthFormat format : kFormats) {
    const auto rendering = rendering_with(scene, format);
    if (!rendering) continue;
    EXPECT_EQ(rendering->pixels, without.pixels);
    EXPECT_EQ(rendering->hits, without.hits);
    ASSERT_EQ(rendering->fragments.size(), without.fragments.size());
    for (std::size_t i = 0; i < without.fragments.size(); ++i)
      EXPECT_EQ(rendering->fragments[i].depth, without.fragments[i].depth);
    // The next scene starts at 1 again, and the next one without has none.
    Scene empty = blank(16, 16);
    const auto cleared = rendering_with(empty, format);
    ASSERT_TRUE(cleared.has_value());
    EXPECT_THAT(cleared->depths, Each(1.0));
    EXPECT_TRUE(render(renderer(), scene).depths.empty());
  }
}

TEST_P(DepthTest, EveryPlaceHasTheFormatsThatItIsKnownToHave) {
  std::string formats;
  for (DepthFormat format : kFormats)
    if (rendering_with(blank(2, 2), format)) formats += std::string(" ") + name_of(format);
  if (name().starts_with("egl:device")) return;
  if (std::get<1>(GetParam()) == Surface::window) {
    EXPECT_EQ(formats, name().starts_with("osmesa") ? " depth24" : "");
    return;
  }
  // Upon SwiftShader, zink keeps floats where 24 bits were asked for.
  EXPECT_EQ(formats,
            name() == "egl:zink-swiftshader" ? " depth16 depth32f" : " depth16 depth24 depth32f");
}

INSTANTIATE_TEST_SUITE_P(OpenGl, DepthTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
