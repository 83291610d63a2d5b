// SPDX-License-Identifier: MIT
//
// What kernels write to: planes of RGBA8 pixels, and the primitives that fill them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kernels/edge_functions.h"

namespace edgecase {

// Four bytes, red first in memory, as one word.
using PixelWord = std::uint32_t;

// Pixels row by row from the bottom. Behind the last row there is room for kSpare more, which
// kernels may read and write back as they were.
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

// Where samples are drawn: sample s of each pixel lies at places[s] and is written to planes[s]. A
// target that is not multisampled has one plane and kCentrePlace.
struct FillTarget {
  std::span<const PixelPlane> planes;
  std::span<const RawPoint> places;
  PixelBounds bounds;  // of what may be written, within the planes
};

// Each writes, in the order of the primitives, exactly what the predicates of triangle_fill.h and
// diamond_exit.h have inside. Ties of lines must be perturbed ones.
void fill_triangles(const FillTarget& target, std::span<const FlatTriangle> triangles,
                    const TieWeights& ties);
void fill_lines(const FillTarget& target, std::span<const FlatLine> lines, const TieWeights& ties);

// The mean of four samples' planes, byte by byte, rounded to nearest, a tie to the even value. Up
// to kSpare pixels behind the last one are written too.
void resolve_four(std::span<const PixelPlane, 4> samples, const PixelPlane& resolved,
                  std::size_t pixels);

}  // namespace edgecase
