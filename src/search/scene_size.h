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
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/scene.h"

namespace edgecase {

// -------------------------------------------------------------------------------------------- size

struct SceneSize {
  std::int64_t primitives = 0;
  std::int64_t draws = 0;
  std::int64_t joined = 0;    // draws of strips, loops and fans
  std::int64_t settings = 0;  // that are no default: count_settings
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

// ---------------------------------------------------------------------------------------- settings

// Settings: what a scene says beside its primitives, their coordinates and the target's size, and
// how each is put back to its default. The surface stays: it is part of what a find is about.

// One setting of a scene, or of each of its draws.
struct Setting {
  const char* name;  // for tests and messages: "blending"
  // Puts it back to its default, of the draw at `draw` where it is one of draws; false, the scene
  // untouched, where it is there already.
  bool (*reset)(Scene& scene, std::size_t draw);
  bool of_draws;
};

std::span<const Setting> all_settings();

// Settings that are no default, those of draws counted for each draw.
std::int64_t count_settings(const Scene& scene);

// Simpler settings than a scene's own, most of it gone first: all defaults, each setting put back
// in all draws at once, then in one, then numbers and lists that are made smaller only.
std::vector<Scene> simpler_settings(const Scene& scene);

}  // namespace edgecase
