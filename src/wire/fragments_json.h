// SPDX-License-Identifier: MIT
//
// An answer's fragments as JSON, for src/wire alone: as runs, and one by one.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "wire/reading.h"

namespace edgecase::wire {

// Coverage alone, the short form of an answer: an array of integers, four to a run of pixels in a
// row, [primitive, y, x_first, x_last, ...], ends inclusive, y up. A pixel that lies in two runs of
// a primitive was drawn twice. For src/wire alone.

// Most fragments of an answer that tells them as runs, by which few bytes ask for much memory: as
// many as our own OpenGL workers capture at most.
constexpr std::size_t kMostFragments = std::size_t{1} << 24;

// What runs must keep to: the target in pixels, and the number of primitives in the scene.
struct RunBounds {
  int width;
  int height;
  int primitives;
};

// The array, by primitive, then row, then column: the same for the same fragments. And as text.
std::vector<int> coverage_runs(const Rendering& rendering);
std::string coverage_runs_json(const Rendering& rendering);

// The pixels of an array of runs as fragments without depth and colour, in the order of the runs.
// Throws a Refusal for anything else, and for more than kMostFragments.
std::vector<Fragment> read_coverage_runs(const nlohmann::json& value, const Path& path,
                                         const RunBounds& bounds);

// The same of numbers that did not come as JSON.
std::vector<Fragment> fragments_of_runs(const std::vector<int>& numbers, const RunBounds& bounds);

// The fragments of an answer: for src/wire alone. Readers throw a Refusal.

// By primitive: does its draw have a texture?
std::vector<bool> textured_primitives(const Scene& scene);

// An array of fragments, appended to those of a rendering whose sizes are set, with the details
// that they tell. `textured` is that of textured_primitives; there is a primitive where there is a
// fragment.
void read_fragments(const nlohmann::json& value, const Path& path, const Scene& scene,
                    const std::vector<bool>& textured, Rendering& rendering);

}  // namespace edgecase::wire
