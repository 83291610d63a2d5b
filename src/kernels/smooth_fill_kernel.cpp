// SPDX-License-Identifier: MIT
//
// fill_smooth_triangle: walks spans and computes as many pixels at once as a vector has doubles.
#include "kernels/color_planes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/smooth_fill_kernel.cpp"
#include <hwy/foreach_target.h>
// Highway requires its header after the list of targets.
#include <hwy/highway.h>

#include "kernels/code_words-inl.h"
#include "kernels/span_walk.h"

HWY_BEFORE_NAMESPACE();
namespace edgecase {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// One component along a row.
struct RowComponent {
  DoubleVector start, right, decided;
};

// kClamps: whether components may lie outside 0 to 255.
template <bool kClamps>
class SmoothFill {
 public:
  SmoothFill(const PixelPlane& plane, const PixelBounds& box, const ValuePlanes& planes,
             std::vector<PixelPosition>& doubtful)
      : plane_(plane), box_(box), planes_(planes), doubtful_(doubtful) {}

  HWY_INLINE void Span(int y, int first, int last) const {
    const Doubles d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const double rows = y - box_.y_min;
    const RowComponent red = RowOf(0, rows), green = RowOf(1, rows), blue = RowOf(2, rows),
                       alpha = RowOf(3, rows);
    auto x = hn::Iota(d, static_cast<double>(first - box_.x_min));
    const auto step = hn::Set(d, static_cast<double>(lanes));
    PixelWord* const row = plane_.row(y);
    for (int column = first; column <= last; column += lanes, x = hn::Add(x, step)) {
      auto open = hn::FirstN(d, 0);
      auto word = CodeOf(red, x, open);
      word = hn::Or(word, hn::ShiftLeft<8>(CodeOf(green, x, open)));
      word = hn::Or(word, hn::ShiftLeft<16>(CodeOf(blue, x, open)));
      word = hn::Or(word, hn::ShiftLeft<24>(CodeOf(alpha, x, open)));
      StoreWords(word, row + column, last - column + 1);
      if (HWY_UNLIKELY(!hn::AllFalse(d, open))) Tell(open, {column, y}, last);
    }
  }

 private:
  HWY_INLINE RowComponent RowOf(std::size_t c, double rows) const {
    const Doubles d;
    return {hn::Set(d, planes_.corner[c] + planes_.up[c] * rows), hn::Set(d, planes_.right[c]),
            hn::Set(d, .5 - planes_.margin[c])};
  }

  // The nearest code, ties to even. Adds the lanes that are too near to a tie to `open`.
  static HWY_INLINE WordVector CodeOf(const RowComponent& c, DoubleVector x,
                                      hn::Mask<Doubles>& open) {
    const Doubles d;
    const auto value = hn::MulAdd(c.right, x, c.start);
    const auto within = kClamps ? hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 255.0)) : value;
    const auto code = hn::Round(within);
    open = hn::Or(open, hn::Gt(hn::Abs(hn::Sub(within, code)), c.decided));
    return hn::DemoteTo(Words(), code);
  }

  HWY_NOINLINE void Tell(hn::Mask<Doubles> open, PixelPosition first, int last) const {
    AddDoubtful(open, first, last, doubtful_);
  }

  const PixelPlane plane_;
  const PixelBounds box_;
  const ValuePlanes& planes_;
  std::vector<PixelPosition>& doubtful_;
};

// `clamps`: as kClamps.
void FillSmooth(const PixelPlane& plane, const PixelBounds& box,
                const std::array<EdgeFunction, 3>& edges, const ValuePlanes& planes, bool clamps,
                std::vector<PixelPosition>& doubtful) {
  const auto fill_by = [&](const auto& fill) HWY_ATTR {
    walk_spans(edges, box, [&](int y, int first, int last) HWY_ATTR { fill.Span(y, first, last); });
  };
  if (clamps)
    fill_by(SmoothFill<true>(plane, box, planes, doubtful));
  else
    fill_by(SmoothFill<false>(plane, box, planes, doubtful));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace edgecase
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace edgecase {

HWY_EXPORT(FillSmooth);

namespace {

// Whether all means of the corners' colours are 0 to 1 and all pixels lie within the corners.
bool stays_within(const SmoothTriangle& triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    const RawPoint vertex = triangle.vertices[i], corner = triangle.corners[i];
    if (vertex.x != corner.x || vertex.y != corner.y) return false;
    for (const auto component : triangle.colors[i])
      if (!(component >= 0 && component <= 1)) return false;
  }
  return true;
}

}  // namespace

void fill_smooth_triangle(const PixelPlane& plane, const PixelBounds& bounds,
                          const SmoothTriangle& triangle, const TieWeights& ties,
                          std::vector<PixelPosition>& doubtful) {
  const auto& [a, b, c] = triangle.vertices;
  const TriangleSetup setup(a, b, c, ties);
  const PixelBounds box = common_part(setup.box_at(kCentrePlace), bounds);
  if (!setup.has_area() || is_empty(box)) return;
  HWY_DYNAMIC_DISPATCH(FillSmooth)
  (plane, box, setup.edges_at(kCentrePlace),
   value_planes(triangle.corners, triangle.colors, 255, box), !stays_within(triangle), doubtful);
}

}  // namespace edgecase
#endif
