// SPDX-License-Identifier: MIT
//
// Judging renderers of multisampled scenes: each is the exact side under a policy of its own.
#pragma once

#include <set>
#include <string>

#include "model/policy.h"
#include "model/rendering.h"
#include "model/result.h"
#include "model/scene.h"

namespace edgecase {

// Triangles with smooth colours that cover pixels in part, in all directions.
Scene partly_covered(int samples = 4);

Policy policy_with(const std::string& rule, const std::string& alternative);

// Held against exact with samples where the rendering says, and judged alone.
Result judged(const Scene& scene, const Rendering& rendered);

// What a renderer makes of the scene that has one rule otherwise, but reports the positions that
// exact has.
Rendering rendered_with(const Scene& scene, const std::string& rule,
                        const std::string& alternative);

// Of all disagreements and aggregates; of all disagreements.
std::set<std::string> causes_of(const Result& result);
std::set<std::string> rules_of(const Result& result);

}  // namespace edgecase
