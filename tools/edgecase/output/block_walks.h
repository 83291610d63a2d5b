// SPDX-License-Identifier: MIT
//
// How a case's triangles are found by blocks, for `edgecase explain --blocks`: as text, and as what
// a picture shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/policy.h"
#include "model/scene.h"
#include "reports/blocks_svg.h"

namespace edgecase {

// The sides of blocks, pixels, from the outer to the inner ones.
using BlockSizes = std::vector<int>;

// "8" or "32,8": of 2, 4, 8, 16 and 32, each smaller than the one before it. Nothing for any other
// text.
std::optional<BlockSizes> parse_block_sizes(const std::string& text);

// Lines, of each primitive of the scene: a drawing of the blocks and what was asked for it, or why
// it is not walked. The scene is not supersampled.
std::string block_text(const Scene& scene, const Policy& policy, const BlockSizes& sizes);

// The same triangles as a picture; without a panel where none is walked.
BlocksPicture block_picture(const Scene& scene, const Policy& policy, const BlockSizes& sizes);

}  // namespace edgecase
