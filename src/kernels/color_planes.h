// SPDX-License-Identifier: MIT
//
// Smooth values without perspective: planes over the window in double precision, with bounds of
// their errors.
//
// A component at a sample is the sum of c_i w_i(p) / A, where w_i is the edge function opposite to
// vertex i and A the triangle's area; both are integers of at most 61 bits. From pixel to pixel a
// component grows by a constant, its derivative. The result is the 8-bit code nearest to 255 times
// the component. Doubles find it unless they are within their own error of the middle between two
// codes; the kernel then leaves the pixel undecided and lists it.
//
// The error: let M be 255 times the sum of |c_i| (|w_i| + |growth of w_i| over the box) / |A|.
// Every intermediate result is at most M, and a code comes from at most ten roundings of at most
// 2^-53 M each: 2^-49 M in all. The plain path, which must give the same result, errs by at most
// 2^-48 M (rules/values/interpolation.h) and a rounding of 2^-45. `margin` exceeds the sum.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "kernels/kernels.h"

namespace edgecase {

struct SmoothTriangle {
  std::array<RawPoint, 3> vertices;            // for coverage
  std::array<RawPoint, 3> corners;             // for the weights of attributes
  std::array<std::array<float, 4>, 3> colors;  // of the corners, finite
};

// Four values at the centre of a box's lower left pixel, their growth per pixel, and bounds of
// their errors within the box.
struct ValuePlanes {
  std::array<double, 4> corner{};
  std::array<double, 4> right{};
  std::array<double, 4> up{};
  std::array<double, 4> margin{};
};

// `scale` times the means of the corners' values, which are finite. The corners must span an area.
// Values that are equal at all corners have no margin.
ValuePlanes value_planes(const std::array<RawPoint, 3>& corners,
                         const std::array<std::array<float, 4>, 3>& values, double scale,
                         const PixelBounds& box);

// Writes the codes of the covered pixels, and adds pixels whose code is left open to `doubtful`;
// their written code may be off by one. Vertices and corners must each span an area.
void fill_smooth_triangle(const PixelPlane& plane, const PixelBounds& bounds,
                          const SmoothTriangle& triangle, const TieWeights& ties,
                          std::vector<PixelPosition>& doubtful);

// Textured triangles without perspective: one level of detail for all pixels, and a linear filter
// of one level or two.
//
// A texture coordinate is known to a few units of double precision, and the linear filter is
// continuous: on whichever side of a texel's centre the coordinate falls, the colour's error is at
// most the coordinate's error times the steepest slope, 255 codes per texel. So here, too, the
// nearest code is found unless the colour is within its error of the middle between two; such
// pixels are listed.

// A level of RGBA8 texels, row by row from the bottom; its sides are powers of two, at most 2^10.
struct TexelPlane {
  const PixelWord* texels = nullptr;
  int width = 1;
  int height = 1;
};

struct TexturedTriangle {
  std::array<RawPoint, 3> vertices;  // for coverage
  std::array<RawPoint, 3> corners;   // for the weights of attributes
  // s and t of the corners, at most 2^10, and two unused numbers.
  std::array<std::array<float, 4>, 3> coordinates;
  std::array<TexelPlane, 2> levels;
  double weight = 0;            // of the second level, which is not used if this is 0
  double weight_margin = 0;     // bound of the weight's error
  std::array<bool, 2> repeats;  // s and t: repeat, or clamp to edge
};

// As fill_smooth_triangle.
void fill_textured_triangle(const PixelPlane& plane, const PixelBounds& bounds,
                            const TexturedTriangle& triangle, const TieWeights& ties,
                            std::vector<PixelPosition>& doubtful);

}  // namespace edgecase
