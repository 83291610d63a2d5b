// SPDX-License-Identifier: MIT
//
// Which way a scene's triangles face under a choice of rules, their vertices snapped as for their
// coverage, and what that makes of them.
#pragma once

#include <optional>

#include "model/scene.h"
#include "rules/choices.h"
#include "rules/coverage/explain.h"

namespace edgecase {

// Points and lines do.
bool is_front_facing(const ScenePrimitive& primitive, const Target& target,
                     const CoverageChoice& choice);

// Does the primitive make no fragments, since it is culled?
bool is_culled(const ScenePrimitive& primitive, const Target& target, const CoverageChoice& choice);

// Why it is culled, with its outline; nothing where it is not.
std::optional<Explanation> explain_culling(const ScenePrimitive& primitive, const Target& target,
                                           const CoverageChoice& choice);

}  // namespace edgecase
