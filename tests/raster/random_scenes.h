// SPDX-License-Identifier: MIT
//
// Scenes for tests: short forms to write one down, and random ones.
#pragma once

#include <random>
#include <span>
#include <vector>

#include "model/scene.h"

namespace edgecase {

// Opaque; every component a multiple of 1/255 before it is rounded to float32.
Color color_of_bytes(int red, int green, int blue);

// An empty scene over an opaque black target, viewport as large as the target.
Scene blank_scene(int width, int height);

// A draw of one primitive type. Vertex v gets a colour of its own, unlike that of any other vertex
// of the first 60 draws with the same `salt`.
Draw make_draw(Primitive primitive, std::span<const Point> positions, int salt = 0);

// What random scenes are made of.
struct SceneKind {
  int size = 8;              // of the square target, pixels
  std::int64_t step = 8192;  // coordinates are multiples of it, raw
  int max_draws = 4;         // at least 1, of any primitive type
  bool smooth = false;       // interpolation may be smooth
};

// An endless row of scenes, the same on every machine for the same seed. Coordinates reach two
// pixels beyond the target on every side.
class RandomScenes {
 public:
  explicit RandomScenes(std::uint64_t seed) : engine_(seed) {}
  Scene next(const SceneKind& kind);
  // From 0 to count - 1.
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }

 private:
  Point point(const SceneKind& kind);
  std::mt19937_64 engine_;
};

}  // namespace edgecase
