// SPDX-License-Identifier: MIT
//
// Smooth values without perspective: planes over the window in double precision, and how far off
// they can be.
//
// A component at a sample is the sum of c_i w_i(p) / A, where w_i is the edge function opposite to
// vertex i and A the triangle's area: both are integers of at most 61 bits. From pixel to pixel a
// component grows by the same number, its derivative. What counts is the 8-bit code nearest to 255
// times the component, and doubles find it wherever they are not within their own error of the
// middle between two codes. There the kernel does not decide; it tells the pixel.
//
// The error: let M be 255 times the sum of |c_i| (|w_i| + |growth of w_i| over the box) / |A|.
// Every intermediate result is at most M, and a code's number is made by ten roundings at most,
// each of 2^-53 of that: 2^-49 M in all. The plain path, which the result must not differ from, is
// off by no more than 2^-48 M (rules/values/interpolation.h) and a rounding of 2^-45. `margin` is
// more than the sum.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "kernels/pixel_plane.h"

namespace edgecase {

struct SmoothTriangle {
  std::array<RawPoint, 3> vertices;            // as coverage has them
  std::array<RawPoint, 3> corners;             // as the weights of attributes have them
  std::array<std::array<float, 4>, 3> colors;  // of the corners, finite
};

// Four values at the centre of a box's lower left pixel, how much they grow to the next pixel, and
// what they may be off by anywhere in the box.
struct ValuePlanes {
  std::array<double, 4> corner{};
  std::array<double, 4> right{};
  std::array<double, 4> up{};
  std::array<double, 4> margin{};
};

// `scale` times the means of the corners' values, finite. The corners must have an area. Values
// that are the same at all corners have no margin.
ValuePlanes value_planes(const std::array<RawPoint, 3>& corners,
                         const std::array<std::array<float, 4>, 3>& values, double scale,
                         const PixelBounds& box);

// Writes the codes of the pixels that are inside, and adds those to `doubtful` whose code it leaves
// open: they are written too, but may be off by one code. Both sets of three points need an area.
void fill_smooth_triangle(const PixelPlane& plane, const PixelBounds& bounds,
                          const SmoothTriangle& triangle, const TieWeights& ties,
                          std::vector<PixelPosition>& doubtful);

// Textured triangles without perspective: one level of detail for all pixels, and within it the
// linear filter of one level, or of two.
//
// Where a pixel looks a texture up is known to a few units of double precision, and the linear
// filter is continuous: on whichever side of a texel's centre a coordinate comes out, the colour is
// off by no more than the coordinate times the steepest slope, 255 codes a texel. So here, too, the
// nearest code is found wherever the colour is not within its error of the middle between two, and
// the others are told.

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
