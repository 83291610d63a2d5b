// SPDX-License-Identifier: MIT
//
// The output of kernels, planes of RGBA8 pixels, and the primitives that fill them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kernels/edge_functions.h"

namespace edgecase {

// Four bytes as one word, with red first in memory.
using PixelWord = std::uint32_t;

// Pixels row by row from the bottom. Room for kSpare more follows the last row; kernels may read
// these and write them back unchanged.
struct PixelPlane {
  static constexpr std::size_t kSpare = 16;

  PixelWord* pixels = nullptr;
  std::ptrdiff_t stride = 0;  // pixels from one row to the next

  PixelWord* row(int y) const { return pixels + y * stride; }
};

struct FlatTriangle {
  std::array<RawPoint, 3> vertices;
  PixelWord color = 0;
};

struct FlatLine {
  RawPoint a, b;
  PixelWord color = 0;
};

// The samples to draw: sample s of each pixel lies at places[s] and is written to planes[s]. A
// target without multisampling has one plane and kCentrePlace.
struct FillTarget {
  std::span<const PixelPlane> planes;
  std::span<const RawPoint> places;
  PixelBounds bounds;  // the pixels that may be written, within the planes
};

// Both draw primitives in order, and cover exactly the pixels of the predicates in triangle_fill.h
// and diamond_exit.h. The tie rule of lines must be a perturbed one.
void fill_triangles(const FillTarget& target, std::span<const FlatTriangle> triangles,
                    const TieWeights& ties);
void fill_lines(const FillTarget& target, std::span<const FlatLine> lines, const TieWeights& ties);

// The mean of four samples' planes, byte by byte, rounded to nearest, ties to even. Up to kSpare
// pixels behind the last one are written too.
void resolve_four(std::span<const PixelPlane, 4> samples, const PixelPlane& resolved,
                  std::size_t pixels);

}  // namespace edgecase
