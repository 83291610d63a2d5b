// SPDX-License-Identifier: MIT
#include "generate/clip_scenes.h"

#include <gtest/gtest.h>

#include "model/scene.h"

namespace edgecase {
namespace {

TEST(ClipScenes, LeaveTheVolumeWithOneVertex) {
  for (const ClipPlace place : values_of<ClipPlace>())
    for (std::uint64_t s = 0; s < 200; ++s) {
      const Scene scene = clip_scene(1, Surface::fbo, place, s);
      int outside = 0;
      for (const Vertex& vertex : scene.draws[0].vertices)
        outside += is_in_clip_volume(*vertex.clip) ? 0 : 1;
      EXPECT_EQ(outside, 1);
      EXPECT_TRUE(primitives_of(scene)[0].is_clipped);
    }
}

}  // namespace
}  // namespace edgecase
