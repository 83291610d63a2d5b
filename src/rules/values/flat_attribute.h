// SPDX-License-Identifier: MIT
//
// Flat attributes and the provoking vertex (GL 4.6 core, flat shading in chapter 13).
//
// A flat attribute takes the value of one vertex of the primitive, the provoking vertex. That is
// the last vertex by default, and the first where the scene asks for it. Nothing is computed, so
// the value must arrive unchanged.
#pragma once

#include <cstddef>

#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

Rule flat_attribute_rule();
Rule provoking_vertex_rule();

enum class ProvokingChoice { as_set, first, last };
template <>
inline constexpr auto kNames<ProvokingChoice> = std::to_array<TabledAlternative<ProvokingChoice>>(
    {{ProvokingChoice::as_set, "as-set", Openness::mandated,
      "the vertex that the scene's convention names"},
     {ProvokingChoice::first, "first", Openness::illegal,
      "the first vertex, whatever the scene says"},
     {ProvokingChoice::last, "last", Openness::illegal,
      "the last vertex, whatever the scene says"}});

// The index of the provoking vertex, 0 to vertices_of(kind) - 1.
std::size_t provoking_index(const ScenePrimitive& primitive, ProvokingChoice choice);

}  // namespace edgecase
