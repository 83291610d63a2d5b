// SPDX-License-Identifier: MIT
//
// Settings: everything in a scene except its primitives, their coordinates and the target's size,
// and how to reset each to its default. The surface is never reset: a find depends on it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "model/scene.h"

namespace edgecase {

// One setting of a scene, or of each of its draws.
struct Setting {
  const char* name;  // for tests: its key, or what has none: "colours"
  // Resets it to its default, in the draw at `draw` if it is one of draws. Returns false, and
  // leaves the scene unchanged, if it already is.
  std::function<bool(Scene& scene, std::size_t draw)> reset;
  bool of_draws;
};

// Those with a row in model/scene_fields.h are taken from there.
std::span<const Setting> all_settings();

// The number of settings other than the default; those of draws count for each draw.
std::int64_t count_settings(const Scene& scene);

// Simpler settings than a scene's own, largest simplification first: all defaults, each setting
// reset in all draws at once, then in one, then numbers and lists made smaller.
std::vector<Scene> simpler_settings(const Scene& scene);

}  // namespace edgecase
