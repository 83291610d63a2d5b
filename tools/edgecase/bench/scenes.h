// SPDX-License-Identifier: MIT
//
// What `edgecase bench` has drawn side by side: scenes whose rates are known to matter, and cases
// of the size that a suite has.
//
// A triangle "of n px" is right-angled, its legs n pixels long; a line "of n px" is n pixels long
// along its major axis. Places and directions are random, from a fixed seed, vertices multiples of
// 1/256 pixel.
#pragma once

#include <string>
#include <vector>

#include "model/case.h"
#include "model/scene.h"

namespace edgecase {

struct BenchScene {
  std::string name;
  // One above the other: each with one draw, all with the same target. A renderer is waited for
  // after each, where there are several. One that asks for details is captured: both sides make
  // its whole Rendering.
  std::vector<Scene> layers;
  std::string unit;  // what `items` counts
  double items = 0;  // of one frame, all layers
};

// On a target of `side` times `side` pixels, a power of two of 64 to 1024.
std::vector<BenchScene> bench_scenes(int side);

// All layers in one scene.
Scene whole_scene(const BenchScene& scene);

// About `count` cases of 64x64 pixels, a triangle and lines that a sweep moves; those of a case
// file that is written here.
std::vector<Case> bench_cases(std::size_t count);

}  // namespace edgecase
