// SPDX-License-Identifier: MIT
//
// SceneSize: how simple a scene is for people who want to understand it.
//
// One order on scenes, by the first of these that differs: primitives, draws, primitives that share
// vertices, settings other than the default, the finest coordinate, the target, and how round,
// aligned and near to the origin the coordinates are together. Every part is a whole number of at
// least 0, so every descending sequence of scenes is finite.
#pragma once

#include <compare>
#include <cstdint>

#include "model/scene.h"

namespace edgecase {

struct SceneSize {
  std::int64_t primitives = 0;
  std::int64_t draws = 0;
  std::int64_t joined = 0;    // draws of strips, loops and fans
  std::int64_t settings = 0;  // other than the default: count_settings
  // The total of large or numerous settings: passes, samples, texels, widths, colours.
  std::int64_t extent = 0;
  std::int64_t fraction_bits = 0;  // of the finest coordinate
  std::int64_t pixels = 0;         // of the target
  std::int64_t sides = 0;          // its width and height
  std::int64_t all_bits = 0;       // fraction bits of all coordinates
  std::int64_t values = 0;         // distinct x, and distinct y
  std::int64_t distance = 0;       // magnitudes of all coordinates, in units of 2^-16
  friend auto operator<=>(const SceneSize&, const SceneSize&) = default;
};

SceneSize size_of(const Scene& scene);

// The fraction bits of a number: 0 for whole numbers, 16 for odd multiples of 2^-16.
int fraction_bits_of(Fixed value);

// The fraction bits of the finest x, y or z of any vertex. Clip coordinates count by their nearest
// window coordinates.
int fraction_bits_of(const Scene& scene);

}  // namespace edgecase
