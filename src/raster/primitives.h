// SPDX-License-Identifier: MIT
//
// Questions about single primitives that come before their pixels: which way they face, whether
// they are culled, and by which blocks they would be found.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "model/scene.h"
#include "rules/choices.h"
#include "rules/coverage/block_walk.h"
#include "rules/coverage/explain.h"

namespace edgecase {

// Which way a scene's triangles face under a choice of rules, their vertices snapped as for their
// coverage, and what that makes of them.

// Points and lines do.
bool is_front_facing(const ScenePrimitive& primitive, const Target& target,
                     const CoverageChoice& choice);

// Does the primitive make no fragments, since it is culled?
bool is_culled(const ScenePrimitive& primitive, const Target& target, const CoverageChoice& choice);

// Why it is culled, with its outline; nothing where it is not.
std::optional<Explanation> explain_culling(const ScenePrimitive& primitive, const Target& target,
                                           const CoverageChoice& choice);

// How a scene's triangles would be found by blocks, under a choice of rules. The rasterizer itself
// finds them otherwise; a block walk finds the same ones and shows how little of it need be asked.
struct PrimitiveBlocks {
  HomogeneousTriangle triangle{};  // where its vertices lie for its coverage
  SamplePositions places;          // of the samples of a pixel that are asked
  BlockWalk walk;
  std::string absence;  // why there is no walk, a sentence without its end; empty: there is one
};

// The walk of a primitive within what its draw may write, the sample mask apart. `sizes`: of
// blocks, as BlockGrid has them.
PrimitiveBlocks blocks_of(const ScenePrimitive& primitive, const Target& target,
                          const CoverageChoice& choice, std::span<const int> sizes);

}  // namespace edgecase
