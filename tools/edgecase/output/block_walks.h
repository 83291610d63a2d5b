// SPDX-License-Identifier: MIT
//
// The block walks of a case's triangles, for `edgecase explain --blocks`: as text, and as the
// content of a picture.
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

// Parses "8" or "32,8": sides of 2, 4, 8, 16 or 32, each smaller than the one before it. Nothing
// for any other text.
std::optional<BlockSizes> parse_block_sizes(const std::string& text);

// Lines for each primitive of the scene: a drawing of the blocks and the number of tests, or why it
// is not walked. The scene must not be supersampled.
std::string block_text(const Scene& scene, const Policy& policy, const BlockSizes& sizes);

// The same triangles as a picture, without panels if none is walked.
BlocksPicture block_picture(const Scene& scene, const Policy& policy, const BlockSizes& sizes);

}  // namespace edgecase
