// SPDX-License-Identifier: MIT
//
// Data for showing a comparison: the disputed fragments, which either side makes at pixels that
// differ, and the level of detail along a ramp. No verdict depends on it.
#pragma once

#include <cstddef>
#include <vector>

#include "diff/compare.h"
#include "model/rendering.h"
#include "model/result.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// A comparison in which both sides together have at most this many fragments reports all of them.
constexpr std::size_t kMostOfSmall = 64;

// Fills the result's lists of fragments, in the order of passes and, within a pass, of renderings.
// Beyond kMostOfSmall they have all fragments at the pixels of disagreements, and at the worst
// location of each aggregate with differing values. Both renderings must have the size of the
// rendering that `result` is about.
void report_fragments(const Rendering& exact, const Rendering& rendered, Result& result);

// Cases with this tag are plotted; for others the band would cost more than the comparison.
inline constexpr const char* kRampTag = "ramp";

// The level of detail along a ramp: exact, the permitted band, rendered. Takes the fragments of
// textured draws whose level the renderer reports, in the lowest row that has any, in the order of
// their pixels; empty without any.
std::vector<Result::LevelPoint> level_ramp(const Scene& scene, const ResolvedPolicy& policy,
                                           const Rendering& rendered, const RendererFacts& facts);

}  // namespace edgecase
