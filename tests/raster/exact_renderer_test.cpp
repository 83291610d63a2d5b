// SPDX-License-Identifier: MIT
#include "raster/rasterizer.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

std::vector<Scene> some_scenes(int count) {
  RandomScenes random(4);
  std::vector<Scene> scenes;
  for (int i = 0; i < count; ++i) scenes.push_back(random.next({6 + i, Fixed::kOne / 8, 3, true}));
  return scenes;
}

std::vector<Task> tasks_of(const std::vector<Scene>& scenes) {
  std::vector<Task> tasks;
  for (const Scene& scene : scenes) tasks.push_back({"case", &scene});
  return tasks;
}

TEST(ExactRenderer, AnswersABatchInOrderAndOnce) {
  const auto scenes = some_scenes(10);
  Policy policy;
  policy.rules = {{"triangle.fill-rule", "bottom-right"}};
  ExactRenderer renderer(policy);
  std::size_t next = 0;
  renderer.render(tasks_of(scenes), [&](std::size_t index, Outcome outcome) {
    ASSERT_EQ(index, next++);
    const auto& rendering = std::get<Rendering>(outcome);
    const Rendering alone = rasterize(scenes[index], policy);
    EXPECT_EQ(rendering.width, scenes[index].target.width);
    EXPECT_EQ(rendering.pixels, alone.pixels);
    EXPECT_EQ(rendering.hits, alone.hits);
    EXPECT_EQ(rendering.fragments.size(), alone.fragments.size());
  });
  EXPECT_EQ(next, scenes.size());
}

TEST(ExactRenderer, StopsWhenTheSinkThrows) {
  const auto scenes = some_scenes(5);
  ExactRenderer renderer{Policy{}};
  int seen = 0;
  EXPECT_THROW(renderer.render(tasks_of(scenes),
                               [&](std::size_t, const Outcome&) {
                                 if (++seen == 2) throw std::runtime_error("enough");
                               }),
               std::runtime_error);
  EXPECT_EQ(seen, 2);
}

TEST(ExactRenderer, SaysWhoItIs) {
  Policy policy;
  policy.name = "vulkan-strict";
  const RendererInfo info = ExactRenderer(policy).info();
  EXPECT_EQ(info.name, "exact");
  EXPECT_EQ(info.version, "policy vulkan-strict");
  EXPECT_EQ(info.subpixel_bits, 16);
}

TEST(ExactRenderer, AnEmptyBatchAsksForNothing) {
  ExactRenderer renderer{Policy{}};
  renderer.render({}, [](std::size_t, const Outcome&) { FAIL(); });
}

}  // namespace
}  // namespace edgecase
