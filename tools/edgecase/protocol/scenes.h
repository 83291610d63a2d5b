// SPDX-License-Identifier: MIT
//
// The scenes for examining a program's protocol. They test its answers, not its rasterization: a
// pixel with a required colour lies far from every edge, so that any rule gives the same.
#pragma once

#include <string>
#include <vector>

#include "model/scene.h"

namespace edgecase {

// A red target without draws.
Scene empty_scene(int width, int height);

// At least two primitives of one type, each larger than a pixel, white on black.
Scene scene_of(Primitive primitive);

// Many triangles, lines and points without extent, and others that cross the target.
Scene scene_without_extent();

// A scene with an optional feature.
struct FeatureScene {
  std::string name;  // "a depth buffer"
  Scene scene;
  // A pixel, and its red, green and blue, 0 to 255, each to within `reach`.
  int x = 0;
  int y = 0;
  int color[3] = {0, 0, 0};
  int reach = 0;
  // All fragments of the second of two triangles fail this test: "depth"; empty: none.
  std::string failed_test{};
};
std::vector<FeatureScene> feature_scenes();

}  // namespace edgecase
