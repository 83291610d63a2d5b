// SPDX-License-Identifier: MIT
//
// A triangle by blocks: many samples decided by one.
//
// Rasterizers do not test every sample. They divide the triangle's bounding box into blocks of
// pixels and test each block with the three edges (Pineda, "A Parallel Algorithm for Polygon
// Rasterization", 1988; Abrash, "Rasterization on Larrabee", 2009). A block wholly outside one edge
// is rejected; a block inside all edges is accepted; of any other, the samples or smaller blocks
// are tested.
//
// An edge function is linear, and the samples of a block are all sums of a column, a row and a
// position within the pixel. The function is largest where each of the three is chosen by itself,
// by the sign of the edge's normal. That is the innermost corner of the block, and the opposite one
// is outermost. Ties do not change this. A tie rule moves all samples of an edge alike, so it adds
// the same to all values, and the largest stays the largest; if the normal is 0 along an axis, the
// samples along it have one value and one tie. So some sample of the block is inside an edge
// exactly if the innermost corner is, and all are exactly if the outermost one is.
//
// The test is exact for one edge, but not for three. A block beside a corner of the triangle can
// have samples inside each edge and none inside all three: it is tested, and covers nothing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rules/coverage/homogeneous_triangle.h"

namespace edgecase {

enum class BlockDecision {
  rejected,  // all of its samples are outside one edge
  accepted,  // all of its samples are inside all edges
  divided,   // neither: its smaller blocks follow
  tested,    // neither: its samples are tested one by one
};
template <>
inline constexpr auto kNames<BlockDecision> =
    std::to_array<Named<BlockDecision>>({{BlockDecision::rejected, "rejected"},
                                         {BlockDecision::accepted, "accepted"},
                                         {BlockDecision::divided, "divided"},
                                         {BlockDecision::tested, "tested"}});

// The samples that a triangle covers in a pixel: bit s for sample s, at least one.
struct PixelSamples {
  PixelPosition pixel;
  std::uint32_t covered = 0;
  friend bool operator==(const PixelSamples&, const PixelSamples&) = default;
};

struct WalkedBlock {
  PixelBounds pixels;  // the part within the bounds, at least one pixel
  int size = 0;        // side in pixels, without regard to the bounds
  BlockDecision decision = BlockDecision::rejected;
  int edge = -1;  // the one that rejects it: 0 from vertex 0 to 1, 2 from 2 to 0
  std::vector<PixelSamples> covered;  // for a tested block, row by row; else empty
};

struct BlockWalk {
  // Pixels within the bounds with a sample in a column and one in a row of the triangle's bounding
  // box.
  PixelBounds box;
  // Row by row from the bottom, left to right; the parts of a divided block come right after it.
  std::vector<WalkedBlock> blocks;
  // How many edge functions were evaluated, each at one sample, and how many a walk over the box's
  // samples needs that leaves a sample at the first edge with the sample outside.
  std::int64_t evaluations = 0;
  std::int64_t plain_evaluations = 0;
};

// The layout of the blocks.
struct BlockGrid {
  static constexpr std::array kCentre = {pixel_centre(0, 0)};

  PixelBounds bounds;          // of the drawable pixels; columns and rows are not negative
  std::span<const int> sizes;  // sides in pixels, each a multiple of the next, at least one
  // The samples in a pixel, 1 to kMaxSamples.
  std::span<const Point> places = kCentre;
};

// Only blocks that meet the bounding box are tested. An edge that has accepted a block is not
// tested again for its parts and samples. A triangle without area has no blocks. All w are
// positive.
BlockWalk walk_blocks(const HomogeneousTriangle& triangle, const BlockGrid& grid,
                      const TieRule& ties);
inline BlockWalk walk_blocks(const Triangle& triangle, const BlockGrid& grid, const TieRule& ties) {
  return walk_blocks(HomogeneousTriangle{homogeneous(triangle[0]), homogeneous(triangle[1]),
                                         homogeneous(triangle[2])},
                     grid, ties);
}

// All samples covered in accepted and tested blocks, sorted by row, column.
std::vector<PixelSamples> covered_samples(const BlockWalk& walk, int samples);

}  // namespace edgecase
