// SPDX-License-Identifier: MIT
//
// What is told for those who show a comparison: disputed fragments, which either side makes at the
// pixels at which they differ, and the level of detail along a ramp. Nothing is judged by it.
#pragma once

#include <cstddef>
#include <vector>

#include "diff/compare.h"
#include "model/rendering.h"
#include "model/result.h"

namespace edgecase {

// A comparison in which both sides together have at most this many fragments tells them all.
constexpr std::size_t kMostOfSmall = 64;

// Fills the result's lists of fragments, in the order of passes and, within a pass, of renderings.
// Beyond kMostOfSmall they hold all fragments at the pixels of disagreements, and at the worst
// place of each aggregate whose values differ. Both renderings have the size that `result` is
// about.
void tell_fragments(const Rendering& exact, const Rendering& rendered, Result& result);

// A case with this tag is plotted: the band costs more than the rest of a comparison.
inline constexpr const char* kRampTag = "ramp";

// The level of detail along a ramp: exact, the permitted band, rendered. Of the fragments of
// textured draws in the lowest row that has any whose level the renderer tells, in the order of
// their pixels; empty without any.
std::vector<Result::LevelPoint> level_ramp(const Scene& scene, const ResolvedPolicy& policy,
                                           const Rendering& rendered, const RendererFacts& facts);

}  // namespace edgecase
