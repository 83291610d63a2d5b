// SPDX-License-Identifier: MIT
//
// Properties of single primitives that precede their pixels: facing, culling, and the blocks of a
// block walk.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "model/scene.h"
#include "rules/choices.h"
#include "rules/coverage/block_walk.h"
#include "rules/coverage/explain.h"

namespace edgecase {

// Which way a scene's triangles face under a choice of rules, with vertices snapped as for
// coverage, and whether they are culled.

// Points and lines are always front-facing.
bool is_front_facing(const ScenePrimitive& primitive, const Target& target,
                     const CoverageChoice& choice);

// Whether the primitive is culled and so makes no fragments.
bool is_culled(const ScenePrimitive& primitive, const Target& target, const CoverageChoice& choice);

// Why the primitive is culled, with its outline; nothing if it is not.
std::optional<Explanation> explain_culling(const ScenePrimitive& primitive, const Target& target,
                                           const CoverageChoice& choice);

// How a block walk would find a scene's triangles under a choice of rules. The rasterizer does not
// walk blocks; a walk covers the same pixels and shows how few need a test.
struct PrimitiveBlocks {
  HomogeneousTriangle triangle{};  // with the vertices used for coverage
  SamplePositions places;          // of the samples tested in each pixel
  BlockWalk walk;
  std::string absence;  // why there is no walk, without a full stop; empty if there is one
};

// The block walk of a primitive within the pixels that its draw may write, ignoring the sample
// mask. `sizes` of blocks, as for BlockGrid.
PrimitiveBlocks blocks_of(const ScenePrimitive& primitive, const Target& target,
                          const CoverageChoice& choice, std::span<const int> sizes);

}  // namespace edgecase
