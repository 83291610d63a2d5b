// SPDX-License-Identifier: MIT
//
// fill_triangles: small triangles by masks, all others by spans. Small ones cut by the bounds also
// go by spans, since their box is no longer their own. Many large ones go tile by tile.
#include "kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/triangle_fill_kernel.cpp"
#include <hwy/foreach_target.h>
// Highway requires its header after the list of targets.
#include <hwy/highway.h>

#include <array>
#include <cstdint>

#include "kernels/edge_functions.h"
#include "kernels/span_walk.h"
#include "kernels/tile_bins.h"

HWY_BEFORE_NAMESPACE();
namespace edgecase {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Small triangles as masks: several columns of a row at once, one per lane.
//
// A box of at most 32 columns and 64 rows needs no alignment: its lower left pixel is the first
// lane. The three functions are or-ed, and the sign of the result shows whether any of them is
// negative. Beyond the box's columns some function is negative anyway (box_at in edge_functions.h),
// so no lane has to be masked off.
//
// 32 bits suffice whatever the vertices' grid: with W columns and H rows in the box, vertices are
// less than W + 1 and H + 1 pixels apart, so right < (H + 1) 2^16 and up < (W + 1) 2^16. A function
// is zero on a line through two vertices, which lie less than a pixel outside the box. From there
// to a lane, at most 7 columns beyond the box, and to the row after its last one the function grows
// by less than right (W + 8) + up (H + 2).

using Lanes32 = hn::CappedTag<std::int32_t, 8>;
constexpr int kMaskColumns = 32;
constexpr int kMaskRows = 64;
static_assert(((std::int64_t{kMaskRows} + 1) * (kMaskColumns + 8) +
               (std::int64_t{kMaskColumns} + 1) * (kMaskRows + 2)) *
                  Fixed::kOne <
              std::int64_t{1} << 31);

HWY_INLINE bool fits_masks(const PixelBounds& box) {
  return box.x_max - box.x_min < kMaskColumns && box.y_max - box.y_min < kMaskRows;
}

// Calls sink(y, x, mask), with a mask of Lanes32 for the pixels from x on, row by row from the
// bottom, including empty masks. `box` must be the triangle's own.
template <class Sink>
HWY_INLINE void WalkMasks(const std::array<EdgeFunction, 3>& edges, const PixelBounds& box,
                          Sink&& sink) {
  const Lanes32 d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto below_zero = hn::Set(d, -1);
  const auto ramp = hn::Iota(d, 0);
  for (int x = box.x_min; x <= box.x_max; x += lanes) {
    const auto start = [&](const EdgeFunction& edge) {
      const auto value = static_cast<std::int32_t>(edge.at(x, box.y_min));
      return hn::Add(hn::Set(d, value),
                     hn::Mul(hn::Set(d, static_cast<std::int32_t>(edge.right)), ramp));
    };
    const auto step = [&](const EdgeFunction& edge) {
      return hn::Set(d, static_cast<std::int32_t>(edge.up));
    };
    auto e0 = start(edges[0]), e1 = start(edges[1]), e2 = start(edges[2]);
    const auto up0 = step(edges[0]), up1 = step(edges[1]), up2 = step(edges[2]);
    for (int y = box.y_min; y <= box.y_max; ++y) {
      sink(y, x, hn::Gt(hn::Or(e0, hn::Or(e1, e2)), below_zero));
      e0 = hn::Add(e0, up0);
      e1 = hn::Add(e1, up1);
      e2 = hn::Add(e2, up2);
    }
  }
}

// Fills `count` pixels, starting at `first`, with one colour.
HWY_INLINE void FillSpan(PixelWord* first, std::ptrdiff_t count, PixelWord color) {
  const hn::ScalableTag<PixelWord> d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  const auto colors = hn::Set(d, color);
  for (; count >= lanes; count -= lanes, first += lanes) hn::StoreU(colors, d, first);
  if (count > 0) hn::BlendedStore(colors, hn::FirstN(d, static_cast<std::size_t>(count)), d, first);
}

HWY_INLINE void FillTriangle(const PixelPlane& plane, const PixelBounds& bounds,
                             const std::array<EdgeFunction, 3>& edges, const PixelBounds& box,
                             PixelWord color) {
  if (is_empty(box)) return;
  if (fits_masks(box) && holds(bounds, box)) {
    const Lanes32 d;
    const auto colors = hn::Set(d, static_cast<std::int32_t>(color));
    WalkMasks(edges, box, [&](int y, int x, auto mask) HWY_ATTR {
      hn::BlendedStore(colors, mask, d, reinterpret_cast<std::int32_t*>(plane.row(y) + x));
    });
    return;
  }
  const PixelBounds some = common_part(box, bounds);
  if (is_empty(some)) return;
  walk_spans(edges, some, [&](int y, int first, int last) HWY_ATTR {
    FillSpan(plane.row(y) + first, last - first + 1, color);
  });
}

HWY_INLINE void FillRectangle(const PixelPlane& plane, const PixelBounds& part, PixelWord color) {
  for (int y = part.y_min; y <= part.y_max; ++y)
    FillSpan(plane.row(y) + part.x_min, part.x_max - part.x_min + 1, color);
}

TriangleSetup SetUp(const FlatTriangle& triangle, const TieWeights& ties) {
  const auto& [a, b, c] = triangle.vertices;
  return {a, b, c, ties};
}

void FillInOrder(const FillTarget& target, std::span<const FlatTriangle> triangles,
                 const TieWeights& ties) {
  for (const FlatTriangle& triangle : triangles) {
    const TriangleSetup setup = SetUp(triangle, ties);
    if (!setup.has_area()) continue;
    for (std::size_t s = 0; s < target.planes.size(); ++s)
      FillTriangle(target.planes[s], target.bounds, setup.edges_at(target.places[s]),
                   setup.box_at(target.places[s]), triangle.color);
  }
}

void FillByTiles(const PixelPlane& plane, RawPoint place, const PixelBounds& bounds,
                 std::span<const FlatTriangle> triangles, const TieWeights& ties) {
  TileBins bins(bounds);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const TriangleSetup setup = SetUp(triangles[i], ties);
    if (setup.has_area()) bins.add(i, setup.edges_at(place), setup.box_at(place));
  }
  bins.draw([&](std::size_t i, const PixelBounds& part, bool is_covered) HWY_ATTR {
    const FlatTriangle& triangle = triangles[i];
    if (is_covered) return FillRectangle(plane, part, triangle.color);
    const TriangleSetup setup = SetUp(triangle, ties);
    FillTriangle(plane, part, setup.edges_at(place), setup.box_at(place), triangle.color);
  });
}

void FillTriangles(const FillTarget& target, std::span<const FlatTriangle> triangles,
                   const TieWeights& ties) {
  const auto vertices = [&](std::size_t i) { return triangles[i].vertices; };
  if (!wants_bins(triangles.size(), target.bounds, vertices))
    return FillInOrder(target, triangles, ties);
  for (std::size_t s = 0; s < target.planes.size(); ++s)
    FillByTiles(target.planes[s], target.places[s], target.bounds, triangles, ties);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace edgecase
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace edgecase {

HWY_EXPORT(FillTriangles);

void fill_triangles(const FillTarget& target, std::span<const FlatTriangle> triangles,
                    const TieWeights& ties) {
  HWY_DYNAMIC_DISPATCH(FillTriangles)(target, triangles, ties);
}

}  // namespace edgecase
#endif
