// SPDX-License-Identifier: MIT
//
// Who draws layers: the framebuffer all of them, or the plain rasterizer.
#include "raster/rasterizer.h"

#include <gtest/gtest.h>

#include <array>
#include <span>

#include "kernels/kernels.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

Scene layer_of(std::span<const Point> corners, int salt) {
  Scene scene = blank_scene(8, 8);
  scene.draws.push_back(make_draw(Primitive::triangles, corners, salt));
  return scene;
}

Point corner(int x, int y) {
  return {Fixed::from_integer(x), Fixed::from_integer(y)};
}

// A triangle, and one that covers the target.
std::array<Scene, 2> two_layers() {
  return {layer_of(std::array{corner(1, 1), corner(7, 1), corner(1, 7)}, 1),
          layer_of(std::array{corner(0, 0), corner(16, 0), corner(0, 16)}, 2)};
}

std::vector<std::uint8_t> drawn(std::span<const Scene> layers) {
  ExactDrawing drawing(layers, {});
  drawing.draw();
  return drawing.pixels();
}

TEST(ExactDrawing, DrawsTheSameWithAndWithoutKernels) {
  const std::array<Scene, 2> layers = two_layers();
  const std::vector<std::uint8_t> first = rasterize(layers[0], {}).pixels;
  const std::vector<std::uint8_t> last = rasterize(layers[1], {}).pixels;
  ASSERT_NE(first, rasterize(blank_scene(8, 8), {}).pixels);
  ASSERT_NE(first, last);
  for (const std::string& kernels : kernel_names()) {
    ASSERT_TRUE(use_kernels(kernels));
    EXPECT_EQ(drawn(std::span(layers).first(1)), first) << kernels;
    EXPECT_EQ(drawn(layers), last) << kernels;
  }
  use_kernels(kernel_names().front());
}

// Depth tests are not the framebuffer's: one layer that has one, below or above, and the plain
// rasterizer draws both.
TEST(ExactDrawing, DrawsNoLayerByTheFramebufferWhereItCannotDrawAll) {
  for (const std::size_t plain : {0U, 1U}) {
    std::array<Scene, 2> layers = two_layers();
    layers[plain].target.depth = layers[1 - plain].target.depth = DepthFormat::depth24;
    layers[plain].draws[0].operations.depth.function = CompareFunction::lequal;
    EXPECT_EQ(drawn(layers), rasterize(layers[1], {}).pixels);
  }
}

}  // namespace
}  // namespace edgecase
