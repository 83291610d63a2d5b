// SPDX-License-Identifier: MIT
//
// The level of detail along a ramp, for people to look at: exact, the permitted band, rendered.
#pragma once

#include <vector>

#include "diff/compare.h"

namespace edgecase {

// A case with this tag is plotted: the band costs more than the rest of a comparison.
inline constexpr const char* kRampTag = "ramp";

// Of the fragments of textured draws in the lowest row that has any whose level the renderer tells,
// in the order of their pixels; empty without any.
std::vector<Result::LevelPoint> level_ramp(const Scene& scene, const ResolvedPolicy& policy,
                                           const Rendering& rendered, const RendererFacts& facts);

}  // namespace edgecase
