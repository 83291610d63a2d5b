// SPDX-License-Identifier: MIT
//
// fill_triangles: small triangles by masks, all others by spans. A small one that the bounds cut is
// walked by spans too: its box would no longer be its own.
#include "kernels/pixel_plane.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/triangle_fill_kernel.cpp"
#include <hwy/foreach_target.h>
// Highway wants its own header after the list of targets.
#include <hwy/highway.h>

#include "kernels/mask_walk-inl.h"
#include "kernels/span_walk.h"

HWY_BEFORE_NAMESPACE();
namespace edgecase {
namespace HWY_NAMESPACE {
namespace {

// From `first` on, `count` pixels of one colour.
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

void FillTriangles(const SamplePlanes& target, std::span<const FlatTriangle> triangles,
                   const TieWeights& ties) {
  for (const FlatTriangle& triangle : triangles) {
    const auto& [a, b, c] = triangle.vertices;
    const TriangleSetup setup(a, b, c, ties);
    if (!setup.has_area()) continue;
    for (std::size_t s = 0; s < target.planes.size(); ++s)
      FillTriangle(target.planes[s], target.bounds, setup.edges_at(target.places[s]),
                   setup.box_at(target.places[s]), triangle.color);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace edgecase
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace edgecase {

HWY_EXPORT(FillTriangles);

void fill_triangles(const SamplePlanes& target, std::span<const FlatTriangle> triangles,
                    const TieWeights& ties) {
  HWY_DYNAMIC_DISPATCH(FillTriangles)(target, triangles, ties);
}

}  // namespace edgecase
#endif
