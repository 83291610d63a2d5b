// SPDX-License-Identifier: MIT
//
// Orientation, viewports and hit counts of both surfaces, and that neither disturbs the other.
#include <gmock/gmock.h>

#include "tests/reference/opengl_test.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

class SurfacesTest : public OpenGlTest {};

// A letter F with a foot to the left: no symmetry maps it to itself.
Scene letter(Scene scene) {
  scene.draws = {rectangle(256, 0, 2 * 256, 4 * 256, {1, 0, 0, 1}),
                 rectangle(2 * 256, 3 * 256, 4 * 256, 4 * 256, {0, 1, 0, 1}),
                 rectangle(2 * 256, 256, 3 * 256, 2 * 256, {0, 0, 1, 1}),
                 rectangle(0, 0, 256, 256, {1, 1, 0, 1})};
  return scene;
}

constexpr const char* kLetter =
    "......\n"
    ".###..\n"
    ".#....\n"
    ".##...\n"
    "##....\n";

// As `coverage`, by what the pixels show: the letter of the colour, '.' for black.
std::string shown(const Rendering& rendering) {
  std::string text;
  for (int y = rendering.height - 1; y >= 0; --y) {
    for (int x = 0; x < rendering.width; ++x) {
      const auto rgba = pixel(rendering, x, y);
      text += ".rgyb"[(rgba[0] > 0 ? 1 : 0) + (rgba[1] > 0 ? 2 : 0) + (rgba[2] > 0 ? 4 : 0)];
    }
    text += '\n';
  }
  return text;
}

TEST_P(SurfacesTest, AnAsymmetricSceneIsTheRightWayUp) {
  const Rendering rendering = render(renderer(), letter(blank(6, 5)));
  EXPECT_EQ(coverage(rendering), kLetter);
  EXPECT_EQ(shown(rendering), "......\n.rgg..\n.r....\n.rb...\nyr....\n");
}

TEST_P(SurfacesTest, FragmentsAreCapturedWhereTheirPixelsLie) {
  // Each pixel of an odd size in a colour of its own: a rendering and its capture must agree on it.
  Scene scene = blank(7, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) {
      const Color color{static_cast<float>(x) / 255.0f, static_cast<float>(y) / 255.0f, 1, 1};
      scene.draws.push_back(make_draw(Primitive::points, {{x * 256 + 128, y * 256 + 128}}, color));
    }
  }
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.fragments.size(), 35u);
  for (const Fragment& fragment : rendering.fragments) {
    EXPECT_EQ(fragment.primitive, fragment.y * 7 + fragment.x);
    const auto rgba = pixel(rendering, fragment.x, fragment.y);
    EXPECT_EQ(rgba[0], fragment.x);
    EXPECT_EQ(rgba[1], fragment.y);
  }
}

TEST_P(SurfacesTest, ViewportsOfAllKindsLeaveWindowCoordinatesAlone) {
  for (const Viewport& viewport : {Viewport{0, 0, 8, 8}, Viewport{-5, -2, 16, 8},
                                   Viewport{0, 0, 64, 32}, Viewport{-60, -27, 128, 32}}) {
    SCOPED_TRACE(viewport.x);
    Scene scene = letter(blank(6, 5));
    scene.viewport = viewport;
    EXPECT_EQ(coverage(render(renderer(), scene)), kLetter);
  }
}

TEST_P(SurfacesTest, AViewportSmallerThanTheTargetCutsTrianglesAndLines) {
  Scene scene = blank(6, 5);
  scene.viewport = {1, 1, 2, 2};
  scene.draws = {rectangle(-256, -256, 8 * 256, 8 * 256)};
  EXPECT_EQ(coverage(render(renderer(), scene)), "......\n......\n.##...\n.##...\n......\n");
  scene.draws = {make_draw(Primitive::lines, {{-256, 2 * 256 + 100}, {8 * 256, 2 * 256 + 100}})};
  EXPECT_EQ(coverage(render(renderer(), scene)), "......\n......\n.##...\n......\n......\n");
  // Points are clipped by their vertices.
  scene.draws = {
      make_draw(Primitive::points, {{3 * 256 + 128, 256 + 128}, {256 + 128, 256 + 128}})};
  EXPECT_EQ(coverage(render(renderer(), scene)), "......\n......\n......\n.#....\n......\n");
}

TEST_P(SurfacesTest, HitsAgreeWithFragmentsUnderNineLayers) {
  Scene scene = blank(8, 8);
  for (int layer = 0; layer < 9; ++layer)
    scene.draws.push_back(rectangle(layer * 100, layer * 50, 8 * 256 - 10, 7 * 256 + 3));
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.hits.size(), 64u);
  EXPECT_EQ(rendering.hits[rendering.pixel_index(7, 6)], 9u);
  EXPECT_EQ(rendering.hits[rendering.pixel_index(0, 0)], 2u);
  EXPECT_EQ(rendering.hits[rendering.pixel_index(7, 7)], 0u);
}

// Column i has i hits: every count that an 8-bit channel holds, none of them rounded away.
TEST_P(SurfacesTest, EveryHitCountUpTo255IsExact) {
  Scene scene = blank(256, 1);
  for (int layer = 1; layer <= 255; ++layer)
    scene.draws.push_back(
        make_draw(Primitive::lines, {{layer * 256 + 128, 128}, {257 * 256, 128}}));
  scene.viewport = {0, 0, 512, 1};
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.hits.size(), 256u);
  for (std::uint32_t column = 0; column < 256; ++column) ASSERT_EQ(rendering.hits[column], column);
}

TEST_P(SurfacesTest, MoreHitsThanASurfaceCountsAreNoRendering) {
  Scene scene = blank(2, 1);
  std::vector<std::pair<int, int>> positions(300, {384, 128});
  scene.draws = {make_draw(Primitive::points, positions)};
  const Outcome outcome = render_outcome(renderer(), scene);
  if (scene.target.surface == Surface::fbo) {
    ASSERT_TRUE(std::holds_alternative<Rendering>(outcome));
    EXPECT_EQ(std::get<Rendering>(outcome).hits[1], 300u);
    return;
  }
  ASSERT_TRUE(std::holds_alternative<Failure>(outcome));
  EXPECT_EQ(std::get<Failure>(outcome).kind, FailureKind::unsupported);
  EXPECT_THAT(std::get<Failure>(outcome).reason,
              HasSubstr("pixel (1, 0) has more hits than the 255"));
}

TEST_P(SurfacesTest, InterleavedSurfacesAndSizesDoNotDisturbEachOther) {
  // More sizes than are kept, each drawn on this surface and on the other.
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    Scene scene = letter(blank(6 + i % 20, 5 + i % 3));
    scene.viewport = {0, 0, 64, 32};
    Scene other = letter(scene);
    other.target.surface = scene.target.surface == Surface::fbo ? Surface::window : Surface::fbo;
    other.target.clear = {0, 1, 0, 1};
    const Rendering first = render(renderer(), scene);
    render(renderer(), other);
    const Rendering second = render(renderer(), scene);
    ASSERT_EQ(first.fragments.size(), 8u);
    EXPECT_EQ(first.pixels, second.pixels);
    EXPECT_EQ(coverage(first), coverage(second));
  }
}

INSTANTIATE_TEST_SUITE_P(OpenGl, SurfacesTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
