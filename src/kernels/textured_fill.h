// SPDX-License-Identifier: MIT
//
// Textured triangles without perspective: one level of detail for all pixels, and within it the
// linear filter of one level, or of two.
//
// Where a pixel looks a texture up is known to a few units of double precision, and the linear
// filter is continuous: on whichever side of a texel's centre a coordinate comes out, the colour is
// off by no more than the coordinate times the steepest slope, 255 codes a texel. So here, too, the
// nearest code is found wherever the colour is not within its error of the middle between two, and
// the others are told.
#pragma once

#include <array>
#include <vector>

#include "kernels/pixel_plane.h"

namespace edgecase {

// A level of RGBA8 texels, row by row from the bottom; its sides are powers of two, at most 2^10.
struct TexelPlane {
  const PixelWord* texels = nullptr;
  int width = 1;
  int height = 1;
};

struct TexturedTriangle {
  std::array<RawPoint, 3> vertices;  // as coverage has them
  std::array<RawPoint, 3> corners;   // as the weights of attributes have them
  // s and t of the corners, at most 2^10, and two numbers that do not count.
  std::array<std::array<float, 4>, 3> coordinates;
  std::array<TexelPlane, 2> levels;
  double weight = 0;            // of the second level; 0: it is not looked up
  double weight_margin = 0;     // by which that may be off
  std::array<bool, 2> repeats;  // s and t; if not, they are clamped to the edge
};

// As fill_smooth_triangle.
void fill_textured_triangle(const PixelPlane& plane, const PixelBounds& bounds,
                            const TexturedTriangle& triangle, const TieWeights& ties,
                            std::vector<PixelPosition>& doubtful);

}  // namespace edgecase
