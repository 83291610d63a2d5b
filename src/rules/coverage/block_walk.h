// SPDX-License-Identifier: MIT
//
// A triangle by blocks: many samples decided by one.
//
// Rasterizers do not ask every sample. They lay blocks of pixels over the triangle's bounding box
// and hold each against the three edges (Pineda, "A Parallel Algorithm for Polygon Rasterization",
// 1988; Abrash, "Rasterization on Larrabee", 2009): one that an edge has wholly outside is
// rejected, one that all edges have inside is accepted, and of what is left the samples are tested,
// or smaller blocks.
//
// An edge function is linear, and the samples of a block are all sums of a column, a row and a
// place within the pixel. Where it is largest, each of the three is chosen by itself, by the sign
// of the edge's normal: that is the corner of the block that lies most inside, and the opposite one
// lies most outside. Ties change nothing of it. A tie rule moves all samples of an edge alike, so
// that it adds the same to all of its values, and which is largest stays; where the normal is 0
// along an axis, samples along it have one value and one tie. Hence an edge has some sample of the
// block inside exactly if the corner most inside is, and all of them exactly if the one most
// outside is.
//
// Of one edge the test is exact; of three it is not. A block beside a corner of the triangle can
// have samples inside each edge and none inside all three: it is tested, and covers nothing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rules/coverage/triangle_algorithm.h"

namespace edgecase {

enum class BlockDecision {
  rejected,  // one edge has all of its samples outside
  accepted,  // all edges have all of its samples inside
  divided,   // neither: smaller blocks of it follow
  tested,    // neither: its samples are asked one by one
};

// "rejected", "accepted", "divided", "tested".
const char* name_of(BlockDecision decision);

// What a triangle covers of a pixel: bit s for sample s, at least one.
struct PixelSamples {
  PixelPosition pixel;
  std::uint32_t covered = 0;
  friend bool operator==(const PixelSamples&, const PixelSamples&) = default;
};

struct WalkedBlock {
  PixelBounds pixels;  // those of the block that lie within the bounds, at least one
  int size = 0;        // of its side, pixels, the bounds apart
  BlockDecision decision = BlockDecision::rejected;
  int edge = -1;                      // that rejects it: 0 runs from vertex 0 to 1, 2 from 2 to 0
  std::vector<PixelSamples> covered;  // of a tested block, row by row; of others none
};

struct BlockWalk {
  // Pixels within the bounds that have a sample in a column and one in a row of the triangle's
  // bounding box.
  PixelBounds box;
  // Row by row from the bottom, left to right; the parts of a divided block come right after it.
  std::vector<WalkedBlock> blocks;
  // How many edge functions were evaluated, each at one sample, and how many a walk over the
  // samples of the box takes that leaves a sample at the first edge that has it outside.
  std::int64_t evaluations = 0;
  std::int64_t plain_evaluations = 0;
};

// How the blocks lie.
struct BlockGrid {
  static constexpr std::array kCentre = {pixel_centre(0, 0)};

  PixelBounds bounds;          // of what may be drawn, columns and rows not negative
  std::span<const int> sizes;  // of sides, pixels, each a multiple of the next, at least one
  // Of the samples in a pixel, 1 to kMaxSamples.
  std::span<const Point> places = kCentre;
};

// Blocks that do not meet the bounding box are not asked. An edge that has accepted a block is not
// asked again for its parts and samples. A triangle without area has no blocks. All w are positive.
BlockWalk walk_blocks(const HomogeneousTriangle& triangle, const BlockGrid& grid,
                      const TieRule& ties);
inline BlockWalk walk_blocks(const Triangle& triangle, const BlockGrid& grid, const TieRule& ties) {
  return walk_blocks(HomogeneousTriangle{homogeneous(triangle[0]), homogeneous(triangle[1]),
                                         homogeneous(triangle[2])},
                     grid, ties);
}

// All that the walk covers, of accepted blocks and of tested ones, sorted by row, column.
std::vector<PixelSamples> covered_samples(const BlockWalk& walk, int samples);

}  // namespace edgecase
