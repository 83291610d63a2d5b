// SPDX-License-Identifier: MIT
//
// SceneSize: how simple a scene is, for people who are to understand what it shows.
//
// One order on scenes, by the first of these that differs: primitives, draws, primitives that share
// vertices, settings that are no default, the finest coordinate, the target, and how round, aligned
// and near to the origin the coordinates are together. Every part is a whole number of at least 0,
// so that no row of ever simpler scenes goes on for ever.
#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "model/scene.h"

namespace edgecase {

struct SceneSize {
  std::int64_t primitives = 0;
  std::int64_t draws = 0;
  std::int64_t joined = 0;    // draws of strips, loops and fans
  std::int64_t settings = 0;  // that are no default: count_settings of search/settings.h
  // Of what is many or large among the settings: passes, samples, texels, widths, colours.
  std::int64_t extent = 0;
  std::int64_t fraction_bits = 0;  // of the finest coordinate
  std::int64_t pixels = 0;         // of the target
  std::int64_t sides = 0;          // its width and height
  std::int64_t all_bits = 0;       // fraction bits of all coordinates
  std::int64_t values = 0;         // different x, and different y
  std::int64_t distance = 0;       // magnitudes of all coordinates, in units of 2^-16
  friend auto operator<=>(const SceneSize&, const SceneSize&) = default;
};

SceneSize size_of(const Scene& scene);

// The fraction bits that a number has: 0 of whole numbers, 16 of odd multiples of 2^-16.
int fraction_bits_of(Fixed value);

// Of the finest x, y or z that a vertex has. Clip coordinates count by the window coordinates
// nearest to where they land.
int fraction_bits_of(const Scene& scene);

}  // namespace edgecase
