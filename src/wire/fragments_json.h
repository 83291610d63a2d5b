// SPDX-License-Identifier: MIT
//
// An answer's fragments as JSON, as runs or one by one, for use in src/wire only.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "wire/json_values.h"

namespace edgecase::wire {

// Coverage only, the short form of an answer: an array of integers, four for each run of pixels in
// a row, [primitive, y, x_first, x_last, ...], ends inclusive, y up. A pixel in two runs of a
// primitive was drawn twice.

// The largest number of fragments in runs, of which few bytes could demand much memory. Our own
// OpenGL workers capture at most this many.
constexpr std::size_t kMostFragments = std::size_t{1} << 24;

// The limits of runs: the target in pixels, and the number of primitives in the scene.
struct RunBounds {
  int width;
  int height;
  int primitives;
};

// The array, by primitive, then row, then column; equal fragments give equal arrays. Also as text.
std::vector<int> coverage_runs(const Rendering& rendering);
std::string coverage_runs_json(const Rendering& rendering);

// The pixels of an array of runs as fragments without depth and colour, in order of the runs.
// Throws a Refusal for an invalid array and for more than kMostFragments.
std::vector<Fragment> read_coverage_runs(const nlohmann::json& value, const Path& path,
                                         const RunBounds& bounds);

// The same for numbers from another source than JSON.
std::vector<Fragment> fragments_of_runs(const std::vector<int>& numbers, const RunBounds& bounds);

// The fragments of an answer. Readers throw a Refusal.

// For each primitive, whether its draw has a texture.
std::vector<bool> textured_primitives(const Scene& scene);

// Reads an array of fragments and their details, and appends them to a rendering with known sizes.
// `textured` is the result of textured_primitives; a scene without primitives has no fragments.
void read_fragments(const nlohmann::json& value, const Path& path, const Scene& scene,
                    const std::vector<bool>& textured, Rendering& rendering);

}  // namespace edgecase::wire
