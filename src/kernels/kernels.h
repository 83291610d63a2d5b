// SPDX-License-Identifier: MIT
//
// The kernels: the planes of RGBA8 pixels that they fill, the primitives that fill them, the pixels
// that they find, and which of them run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exact/fixed.h"
#include "kernels/edge_functions.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

// The output of kernels, planes of RGBA8 pixels, and the primitives that fill them.

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

// Selects which kernels run, to compare results or to measure costs.

// The names that `use_kernels` accepts: the compiled SIMD targets that this machine has, as Highway
// names them (AVX2, SSE4, ...), then "none".
std::vector<std::string> kernel_names();

// Restricts kernels to one target; with "none" the predicates and the plain stages decide
// everything. Returns false and changes nothing if the name is not one of kernel_names. Call it
// before other threads draw.
bool use_kernels(std::string_view name);

// Whether the latest choice is anything but "none".
bool kernels_are_used();

// Lists the pixels that the kernels' walks find in a primitive.

// The pixels of triangle_covers within the bounds, which lie within the window, sorted by row, then
// column. Vertices must satisfy is_raw_point.
std::vector<PixelPosition> walked_triangle_pixels(const Triangle& triangle,
                                                  const PixelBounds& bounds, const TieRule& ties);

// Whether walked_triangle_pixels would give exactly these distinct pixels, in the same order.
bool walks_just(std::span<const PixelPosition> pixels, const Triangle& triangle,
                const PixelBounds& bounds, const TieRule& ties);

// The pixels whose samples lie on the triangle's edges, in the same order.
std::vector<PixelPosition> walked_tied_pixels(const Triangle& triangle, const PixelBounds& bounds);

// The pixels of diamond_exit_covers, ascending along the segment's major axis. The tie rule must be
// a perturbed one.
std::vector<PixelPosition> walked_line_pixels(const Segment& segment, const PixelBounds& bounds,
                                              const TieRule& ties);

}  // namespace edgecase
