// SPDX-License-Identifier: MIT
//
// The scenes of `edgecase bench`: scenes whose rates matter, and cases as large as those of a
// suite.
//
// A triangle "of n px" is right-angled with legs n pixels long; a line "of n px" is n pixels long
// along its major axis. Positions and directions are random, from a fixed seed; vertices are
// multiples of 1/256 pixel.
#pragma once

#include <string>
#include <vector>

#include "model/case.h"
#include "model/scene.h"

namespace edgecase {

struct BenchScene {
  std::string name;
  // Drawn in order: each has one draw, and all have the same target. If there are several, each is
  // finished before the next. A layer with details is captured: both sides make its whole
  // Rendering.
  std::vector<Scene> layers;
  std::string unit;  // what `items` counts
  double items = 0;  // of one frame, all layers
};

// On a target of `side` times `side` pixels; `side` is a power of two from 64 to 1024.
std::vector<BenchScene> bench_scenes(int side);

// All layers in one scene.
Scene whole_scene(const BenchScene& scene);

// About `count` cases of 64x64 pixels from a case file that is generated here: a triangle and
// lines, moved by a sweep.
std::vector<Case> bench_cases(std::size_t count);

}  // namespace edgecase
