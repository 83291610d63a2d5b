// SPDX-License-Identifier: MIT
//
// Texture lookups of fragments, held against what is exact and what the specification permits: the
// level of detail that the renderer tells (rulings 19 to 22), the colours that it looked up
// (rulings 20 to 24) and the mip chains that it made (ruling 25).
//
// What an open way yields is aggregated, one aggregate for each way with the way as its cause: a
// renderer that approximates the logarithm does so at every fragment. What only an illegal way
// yields, or none and is not permitted, is a disagreement of its own.
#pragma once

#include "diff/textures/texture_lookups.h"
#include "diff/values/value_diff.h"

namespace edgecase {

// Each appends disagreements and aggregates to `result`. `profile`: what the renderer is measured
// to follow; null: not known.
void compare_texture_lookups(const ValueContext& context, const Rendering& exact,
                             const Rendering& rendered, const TextureChoice* profile,
                             Result& result);

void compare_mip_chains(const ValueContext& context, const Rendering& exact,
                        const Rendering& rendered, Result& result);

}  // namespace edgecase
