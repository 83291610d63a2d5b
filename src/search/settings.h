// SPDX-License-Identifier: MIT
//
// Settings: what a scene says beside its primitives, their coordinates and the target's size, and
// how each is put back to its default. The surface stays: it is part of what a find is about.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/scene.h"

namespace edgecase {

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
