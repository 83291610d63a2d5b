// SPDX-License-Identifier: MIT
//
// What a framebuffer draws is to the bit what the plain rasterizer puts into its pixels: random
// scenes of every primitive, under every tie order and several grids, flat and smooth, of one
// sample and of more.
#include "raster/framebuffer.h"

#include <gtest/gtest.h>

#include <span>

#include "kernels/tile_bins.h"
#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr const char* kOrders[] = {"left-bottom", "left-top",  "right-bottom", "right-top",
                                   "bottom-left", "top-right", "open",         "closed"};
constexpr const char* kSnaps[] = {"none", "8-half-even", "4-truncate", "6-half-up"};

Policy random_policy(RandomScenes& random) {
  Policy policy;
  policy.rules["triangle.fill-rule"] = kOrders[random.below(8)];
  policy.rules["line.diamond-exit"] = kOrders[random.below(8)];
  policy.rules["subpixel.snap"] = kSnaps[random.below(4)];
  if (random.below(4) == 0) policy.rules["attribute.positions"] = "snapped";
  return policy;
}

// The pixels of a scene that the framebuffer draws; counts it.
std::vector<std::uint8_t> fast_pixels(const Scene& scene, const Policy& policy, int& drawn) {
  Framebuffer framebuffer(scene.target, policy);
  const auto prepared = framebuffer.prepared(scene);
  if (!prepared) return rasterize(scene, policy).pixels;
  ++drawn;
  // What was there before is cleared.
  framebuffer.clear({1, 1, 1, 1});
  framebuffer.clear(scene.target.clear);
  framebuffer.draw(*prepared);
  framebuffer.resolve();
  return framebuffer.pixels();
}

TEST(Framebuffer, DrawsRandomScenesAsThePlainPath) {
  RandomScenes random(share_seed(21));
  int drawn = 0;
  const int count = kernel_scenes(6000);
  for (int i = 0; i < count; ++i) {
    const SceneKind kind{4 + random.below(36), Fixed::kOne >> random.below(17), 4, i % 2 == 0};
    const Scene scene = random.next(kind);
    const Policy policy = random_policy(random);
    ASSERT_EQ(fast_pixels(scene, policy, drawn), rasterize(scene, policy).pixels) << i;
  }
  EXPECT_EQ(drawn, count);
}

// Colours that lie between two codes at many samples: ramps of whole and half codes a pixel, halves
// all over, and values beyond 0 to 1.
TEST(Framebuffer, LeavesTiesOfCodesToThePlainPath) {
  RandomScenes random(share_seed(22));
  int drawn = 0;
  for (int i = 0; i < kernel_scenes(300); ++i) {
    const int size = 5 + random.below(30);
    Scene scene = blank_scene(size, size);
    const auto at = [&](int x, int y) {
      return Point{Fixed::from_integer(x), Fixed::from_integer(y)};
    };
    const Point corners[] = {at(0, 0), at(size, 0), at(0, size), at(size, size)};
    Draw draw = make_draw(Primitive::triangle_strip, corners);
    draw.interpolation = Interpolation::smooth;
    const float step = static_cast<float>(1 + random.below(8)) / 510.0F;
    for (std::size_t v = 0; v < 4; ++v) {
      const float x = v % 2 == 1 ? static_cast<float>(size) : 0, y = v > 1 ? 1 : 0;
      draw.vertices[v].color = {x * step, .5F, y * 3 - 1, random.below(2) == 0 ? y : .5F};
    }
    scene.draws.push_back(draw);
    ASSERT_EQ(fast_pixels(scene, {}, drawn), rasterize(scene, {}).pixels) << i;
  }
  EXPECT_GT(drawn, 0);
}

TEST(Framebuffer, DividesByWWhereTheDrawDoes) {
  RandomScenes random(share_seed(23));
  int drawn = 0;
  for (int i = 0; i < kernel_scenes(300); ++i) {
    Scene scene = random.next({16, Fixed::kOne / 16, 3, true});
    for (Draw& draw : scene.draws) {
      if (random.below(3) == 0) draw.interpolation = Interpolation::noperspective;
      const float w = static_cast<float>(1 + random.below(3));
      for (Vertex& vertex : draw.vertices)
        vertex.w = random.below(3) == 0 ? static_cast<float>(1 + random.below(3)) : w;
    }
    ASSERT_EQ(fast_pixels(scene, {}, drawn), rasterize(scene, {}).pixels) << i;
  }
  EXPECT_GT(drawn, 0);
}

TEST(Framebuffer, DrawsSamplesAsThePlainPath) {
  RandomScenes random(share_seed(24));
  int drawn = 0, asked = 0;
  for (int i = 0; i < kernel_scenes(1500); ++i) {
    Scene scene = random.next({4 + random.below(24), Fixed::kOne >> random.below(17), 4, false});
    scene.target.samples = random.below(4) == 0 ? 2 << random.below(3) : 4;
    std::erase_if(scene.draws, [](const Draw& draw) {
      return kind_of(draw.primitive) != PrimitiveKind::triangle;
    });
    for (Draw& draw : scene.draws)
      if (random.below(3) == 0)
        draw.multisampling.mask = static_cast<std::uint32_t>(random.below(16));
    Policy policy = random_policy(random);
    if (random.below(3) == 0) policy.rules["sample.positions"] = "mirrored-x";
    if (random.below(4) == 0) policy.rules["sample.resolve"] = "half-up";
    if (random.below(8) == 0) policy.rules["sample.mask"] = "ignored";
    ASSERT_EQ(fast_pixels(scene, policy, drawn), rasterize(scene, policy).pixels) << i;
    ++asked;
  }
  EXPECT_EQ(drawn, asked);
}

// Scissor rectangles, and policies that see the target upside down.
TEST(Framebuffer, HoldsTheScissorAndOtherRowOrders) {
  RandomScenes random(share_seed(25));
  int drawn = 0;
  for (int i = 0; i < kernel_scenes(600); ++i) {
    const int size = 4 + random.below(28);
    Scene scene = random.next({size, Fixed::kOne >> random.below(17), 4, true});
    for (Draw& draw : scene.draws)
      draw.scissor = Viewport{random.below(size) - 2, random.below(size) - 2, random.below(size),
                              random.below(size)};
    Policy policy = random_policy(random);
    if (i % 3 == 0) policy.rules["triangle.row-order"] = "top-down";
    if (i % 5 == 0) policy.rules["line.row-order"] = "top-down";
    ASSERT_EQ(fast_pixels(scene, policy, drawn), rasterize(scene, policy).pixels) << i;
  }
  EXPECT_GT(drawn, 0);
}

// Targets of several tiles, whole ones and some that are cut, and triangles enough to go tile by
// tile: flat and smooth, of one sample and of four.
TEST(Framebuffer, DrawsTileByTileAsInOrder) {
  RandomScenes random(share_seed(27));
  int drawn = 0, by_tiles = 0;
  const int count = kernel_scenes(24);
  for (int i = 0; i < count; ++i) {
    const int size = 190 + random.below(80);
    Scene scene = random.next({size, Fixed::kOne >> random.below(17), 1, false});
    scene.draws.clear();
    if (i % 4 == 3) scene.target.samples = 4;
    const bool smooth = i % 4 == 1;
    std::vector<Point> corners;
    // Every other scene has its edges run through the samples in tiles' corners, where ties count.
    for (int v = 0; v < (smooth ? 30 : 45); ++v) {
      const auto corner = [&] { return 64 * random.below(6) - 64 + random.below(2) * 63; };
      if (i % 2 == 0) corners.push_back(pixel_centre(corner(), corner()));
      if (i % 2 == 0) continue;
      const auto at = [&] {
        return Fixed::from_raw(random.below((size + 160) << 16) - (80 << 16));
      };
      corners.push_back({at(), at()});
    }
    Draw draw = make_draw(Primitive::triangles, corners, i);
    if (smooth) draw.interpolation = Interpolation::smooth;
    if (i % 3 == 2) draw.scissor = Viewport{random.below(60), random.below(60), 170, 120};
    scene.draws.push_back(draw);
    const Policy policy = random_policy(random);
    ASSERT_EQ(fast_pixels(scene, policy, drawn), rasterize(scene, policy).pixels) << i;
    const auto vertices = [&](std::size_t t) {
      return std::array{raw_point(corners[3 * t]), raw_point(corners[3 * t + 1]),
                        raw_point(corners[3 * t + 2])};
    };
    const PixelBounds bounds = drawable_bounds(scene.draws[0], scene.target);
    if (wants_bins(corners.size() / 3, bounds, vertices)) ++by_tiles;
  }
  EXPECT_EQ(drawn, count);
  EXPECT_GT(by_tiles, count / 2);
}

TEST(Framebuffer, LeavesOperationsTexturesAndPassesToThePlainPath) {
  Scene scene = RandomScenes(26).next({8, Fixed::kOne / 2, 1, false});
  const auto is_drawn = [&] { return Framebuffer(scene.target, {}).prepared(scene).has_value(); };
  ASSERT_TRUE(is_drawn());
  scene.draws[0].operations.blending = Blending();
  EXPECT_FALSE(is_drawn());
  const Policy policy;
  ExactDrawing drawing(std::span(&scene, 1), policy);
  drawing.draw();
  EXPECT_EQ(drawing.pixels(), rasterize(scene, policy).pixels);
}

}  // namespace
}  // namespace edgecase
