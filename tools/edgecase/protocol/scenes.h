// SPDX-License-Identifier: MIT
//
// The scenes by which a program's protocol is examined. They ask how it answers, never how it
// rasterizes: where a scene says what a pixel shows, that pixel lies far from every edge, and its
// colour is the same by any rule.
#pragma once

#include <string>
#include <vector>

#include "model/scene.h"

namespace edgecase {

// Nothing drawn, on red.
Scene empty_scene(int width, int height);

// Two primitives or more of one type, each larger than a pixel, white on black.
Scene scene_of(Primitive primitive);

// Triangles, lines and points without extent, over and over, and others that cross the target.
Scene scene_without_extent();

// A scene that asks for something a program may lack.
struct FeatureScene {
  std::string name;  // "a depth buffer"
  Scene scene;
  // A pixel, and the red, green and blue that it shows, each to within `reach` of 0 to 255.
  int x = 0;
  int y = 0;
  int color[3] = {0, 0, 0};
  int reach = 0;
};
std::vector<FeatureScene> feature_scenes();

}  // namespace edgecase
