// SPDX-License-Identifier: MIT
//
// Compares texture lookups of fragments with exact and with what the specification permits: the
// level of detail that the renderer reports (rulings 19 to 22), the colours that it looked up
// (rulings 20 to 24) and the mip chains that it made (ruling 25).
//
// Results of an open way are aggregated, one aggregate for each way with the way as its cause: a
// renderer that approximates the logarithm does so at every fragment. A result of an illegal way
// only, or of none and not permitted, is a disagreement of its own.
#pragma once

#include "diff/textures/texture_lookups.h"
#include "diff/values/value_diff.h"

namespace edgecase {

// Each appends disagreements and aggregates to `result`. `profile`: the choices that the renderer
// is measured to follow; null: unknown.
void compare_texture_lookups(const ValueContext& context, const Rendering& exact,
                             const Rendering& rendered, const TextureChoice* profile,
                             Result& result);

void compare_mip_chains(const ValueContext& context, const Rendering& exact,
                        const Rendering& rendered, Result& result);

}  // namespace edgecase
