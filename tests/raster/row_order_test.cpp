// SPDX-License-Identifier: MIT
//
// line.row-order: a target seen upside down. Turning the target over turns every tie over, so the
// diamond-exit rule with rows from the top must draw what it draws with the other vertical tie.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "raster/rasterizer.h"

namespace edgecase {
namespace {

Scene line_scene(Point a, Point b) {
  Scene scene;
  scene.target.width = 4;
  scene.target.height = 3;
  scene.viewport = {0, 0, 4, 4};
  Draw draw;
  draw.primitive = Primitive::lines;
  draw.vertices = {{a, {}, {}}, {b, {}, {}}};
  scene.draws = {draw};
  return scene;
}

std::vector<std::pair<int, int>> drawn(const Scene& scene, const Policy& policy) {
  std::vector<std::pair<int, int>> pixels;
  for (const Fragment& f : rasterize(scene, policy).fragments) pixels.emplace_back(f.x, f.y);
  return pixels;
}

Policy policy_with(Choices rules) {
  Policy policy;
  policy.rules = std::move(rules);
  return policy;
}

Point quarters(int x, int y) {
  return {Fixed::from_raw(x * Fixed::kOne / 4), Fixed::from_raw(y * Fixed::kOne / 4)};
}

TEST(RowOrder, TurnsTheVerticalTieOver) {
  const std::pair<const char*, const char*> turned[] = {{"left-bottom", "left-top"},
                                                        {"right-top", "right-bottom"},
                                                        {"top-left", "bottom-left"},
                                                        {"open", "open"},
                                                        {"closed", "closed"}};
  int scenes = 0;
  int changed = 0;
  for (const auto& [tie, other] : turned)
    for (int ay = 0; ay <= 12; ++ay)
      for (int ax = 0; ax <= 16; ax += 2)
        for (int by = 0; by <= 12; by += 2)
          for (int bx = 0; bx <= 16; bx += 2) {
            const Scene scene = line_scene(quarters(ax, ay), quarters(bx, by));
            const auto seen = drawn(
                scene, policy_with({{"line.diamond-exit", tie}, {"line.row-order", "top-down"}}));
            ASSERT_EQ(seen, drawn(scene, policy_with({{"line.diamond-exit", other}})));
            changed += seen != drawn(scene, policy_with({{"line.diamond-exit", tie}})) ? 1 : 0;
            ++scenes;
          }
  EXPECT_EQ(scenes, 5 * 13 * 9 * 7 * 9);
  EXPECT_GT(changed, 100) << "ties must be turned over, or this proves nothing";
}

// What the integer algorithms do with halves and negative numbers depends on which way is up.
TEST(RowOrder, ChangesBresenham) {
  const Scene scene = line_scene(quarters(2, 6), quarters(14, 8));
  const Policy up = policy_with({{"line.algorithm", "bresenham"}});
  const Policy down =
      policy_with({{"line.algorithm", "bresenham"}, {"line.row-order", "top-down"}});
  EXPECT_NE(drawn(scene, up), drawn(scene, down));
}

}  // namespace
}  // namespace edgecase
