// SPDX-License-Identifier: MIT
//
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
//
// This file is compiled once for each of Highway's targets.
#if defined(EDGECASE_KERNELS_MASK_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EDGECASE_KERNELS_MASK_WALK_INL_H_
#undef EDGECASE_KERNELS_MASK_WALK_INL_H_
#else
#define EDGECASE_KERNELS_MASK_WALK_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstdint>

#include "kernels/edge_functions.h"

HWY_BEFORE_NAMESPACE();
namespace edgecase {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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

}  // namespace HWY_NAMESPACE
}  // namespace edgecase
HWY_AFTER_NAMESPACE();

#endif
