// SPDX-License-Identifier: MIT
//
// The passes of a supersampled scene as JSON: for src/wire alone. Readers throw a Refusal.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/scene.h"
#include "wire/scene_values.h"

namespace edgecase::wire {

// [[x, y, weight], ...] in the order of the passes, x and y in pixels from a pixel's lower left
// corner.
void write_supersampling(Output out, const Supersampling& passes);

// The inverse: 1 to kMaxPasses of them, multiples of 2^-16 of -1 to 2, weights of 1 to
// kMaxPassWeight. There are none where the target has several samples.
Supersampling read_supersampling(const nlohmann::json& value, const Path& path, int samples);

// Refuses a scene whose passes are too much work or move a vertex out of its range; `path` is that
// of the passes.
void check_passes(const Scene& scene, const Path& path);

}  // namespace edgecase::wire
