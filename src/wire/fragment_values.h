// SPDX-License-Identifier: MIT
//
// The fragments of an answer: for src/wire alone. Readers throw a Refusal.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "wire/reading.h"

namespace edgecase::wire {

// By primitive: does its draw have a texture?
std::vector<bool> textured_primitives(const Scene& scene);

// An array of fragments, appended to those of a rendering whose sizes are set, with the details
// that they tell. `textured` is that of textured_primitives; there is a primitive where there is a
// fragment.
void read_fragments(const nlohmann::json& value, const Path& path, const Scene& scene,
                    const std::vector<bool>& textured, Rendering& rendering);

}  // namespace edgecase::wire
