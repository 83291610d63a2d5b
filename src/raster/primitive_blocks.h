// SPDX-License-Identifier: MIT
//
// How a scene's triangles would be found by blocks, under a choice of rules. The rasterizer itself
// finds them otherwise; a block walk finds the same ones and shows how little of it need be asked.
#pragma once

#include <span>
#include <string>

#include "model/scene.h"
#include "rules/choices.h"
#include "rules/coverage/block_walk.h"

namespace edgecase {

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
