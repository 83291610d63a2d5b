// SPDX-License-Identifier: MIT
//
// fill_textured_triangle: walks spans, computes as many pixels at once as a vector has doubles, and
// gathers texels as whole words.
#include "kernels/color_planes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/textured_fill_kernel.cpp"
#include <hwy/foreach_target.h>
// Highway requires its header after the list of targets.
#include <hwy/highway.h>

#include <algorithm>

#include "kernels/code_words-inl.h"
#include "kernels/span_walk.h"

HWY_BEFORE_NAMESPACE();
namespace edgecase {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// The two texels around a coordinate, and the weight of the second.
struct TexelPair {
  WordVector first, second;
  DoubleVector weight;
};

HWY_INLINE WordVector Wrapped(WordVector texel, int size, bool repeats) {
  const Words d;
  const auto last = hn::Set(d, size - 1);
  return repeats ? hn::And(texel, last) : hn::Min(hn::Max(texel, hn::Zero(d)), last);
}

HWY_INLINE TexelPair PairAt(DoubleVector coordinate, int size, bool repeats) {
  const Doubles d;
  const auto place = hn::Sub(hn::Mul(coordinate, hn::Set(d, double(size))), hn::Set(d, .5));
  const auto below = hn::Floor(place);
  const auto texel = hn::DemoteTo(Words(), below);
  return {Wrapped(texel, size, repeats),
          Wrapped(hn::Add(texel, hn::Set(Words(), 1)), size, repeats), hn::Sub(place, below)};
}

// Four texels of a level and their weights.
struct Neighbours {
  WordVector texels[4];
  DoubleVector weights[4];

  HWY_INLINE Neighbours(const TexelPlane& level, const std::array<bool, 2>& repeats, DoubleVector s,
                        DoubleVector t, DoubleVector share) {
    const Doubles d;
    const Words d_words;
    const TexelPair x = PairAt(s, level.width, repeats[0]);
    const TexelPair y = PairAt(t, level.height, repeats[1]);
    const auto* const base = reinterpret_cast<const std::int32_t*>(level.texels);
    const auto width = hn::Set(d_words, level.width);
    const auto row0 = hn::Mul(y.first, width), row1 = hn::Mul(y.second, width);
    texels[0] = hn::GatherIndex(d_words, base, hn::Add(row0, x.first));
    texels[1] = hn::GatherIndex(d_words, base, hn::Add(row0, x.second));
    texels[2] = hn::GatherIndex(d_words, base, hn::Add(row1, x.first));
    texels[3] = hn::GatherIndex(d_words, base, hn::Add(row1, x.second));
    const auto one = hn::Set(d, 1.0);
    const auto upper = hn::Mul(y.weight, share), lower = hn::Mul(hn::Sub(one, y.weight), share);
    weights[1] = hn::Mul(x.weight, lower);
    weights[0] = hn::Sub(lower, weights[1]);
    weights[3] = hn::Mul(x.weight, upper);
    weights[2] = hn::Sub(upper, weights[3]);
  }

  // Adds the weighted codes of a component.
  template <int kComponent>
  HWY_INLINE DoubleVector AddedTo(DoubleVector sum) const {
    const Doubles d;
    const auto byte = hn::Set(Words(), 255);
    for (int i = 0; i < 4; ++i) {
      const auto code = hn::And(hn::ShiftRight<8 * kComponent>(texels[i]), byte);
      sum = hn::MulAdd(weights[i], hn::PromoteTo(d, code), sum);
    }
    return sum;
  }
};

class TexturedFill {
 public:
  TexturedFill(const PixelPlane& plane, const PixelBounds& box, const TexturedTriangle& triangle,
               const ValuePlanes& places, std::vector<PixelPosition>& doubtful)
      : plane_(plane), box_(box), triangle_(triangle), places_(places), doubtful_(doubtful) {
    double steepest = 0;
    for (const TexelPlane& level : triangle.levels)
      steepest =
          std::max(steepest, places.margin[0] * level.width + places.margin[1] * level.height);
    margin_ = 255 * (2 * steepest + triangle.weight_margin) + 0x1p-36;
  }

  HWY_INLINE void Span(int y, int first, int last) const {
    const Doubles d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const double rows = y - box_.y_min;
    const auto row_of = [&](std::size_t c) HWY_ATTR {
      return hn::Set(d, places_.corner[c] + places_.up[c] * rows);
    };
    const auto s0 = row_of(0), t0 = row_of(1);
    const auto s_right = hn::Set(d, places_.right[0]), t_right = hn::Set(d, places_.right[1]);
    auto x = hn::Iota(d, static_cast<double>(first - box_.x_min));
    for (int column = first; column <= last; column += lanes) {
      Chunk({column, y}, last, hn::MulAdd(s_right, x, s0), hn::MulAdd(t_right, x, t0));
      x = hn::Add(x, hn::Set(d, static_cast<double>(lanes)));
    }
  }

 private:
  HWY_INLINE void Chunk(PixelPosition at, int last, DoubleVector s, DoubleVector t) const {
    const Doubles d;
    const double weight = triangle_.weight;
    const Neighbours near(triangle_.levels[0], triangle_.repeats, s, t, hn::Set(d, 1 - weight));
    DoubleVector red = near.AddedTo<0>(hn::Zero(d)), green = near.AddedTo<1>(hn::Zero(d)),
                 blue = near.AddedTo<2>(hn::Zero(d)), alpha = near.AddedTo<3>(hn::Zero(d));
    if (weight != 0) {
      const Neighbours far(triangle_.levels[1], triangle_.repeats, s, t, hn::Set(d, weight));
      red = far.AddedTo<0>(red);
      green = far.AddedTo<1>(green);
      blue = far.AddedTo<2>(blue);
      alpha = far.AddedTo<3>(alpha);
    }
    auto farthest = hn::Zero(d);
    auto word = CodeOf(red, farthest);
    word = hn::Or(word, hn::ShiftLeft<8>(CodeOf(green, farthest)));
    word = hn::Or(word, hn::ShiftLeft<16>(CodeOf(blue, farthest)));
    word = hn::Or(word, hn::ShiftLeft<24>(CodeOf(alpha, farthest)));
    StoreWords(word, plane_.row(at.y) + at.x, last - at.x + 1);
    const auto open = hn::Gt(farthest, hn::Set(d, .5 - margin_));
    if (HWY_UNLIKELY(!hn::AllFalse(d, open))) Tell(open, at, last);
  }

  // The nearest code. `farthest` becomes the largest distance of any component from its code.
  static HWY_INLINE WordVector CodeOf(DoubleVector value, DoubleVector& farthest) {
    const auto code = hn::Round(value);
    farthest = hn::Max(farthest, hn::Abs(hn::Sub(value, code)));
    return hn::DemoteTo(Words(), code);
  }

  HWY_NOINLINE void Tell(hn::Mask<Doubles> open, PixelPosition first, int last) const {
    AddDoubtful(open, first, last, doubtful_);
  }

  const PixelPlane plane_;
  const PixelBounds box_;
  const TexturedTriangle& triangle_;
  const ValuePlanes& places_;
  std::vector<PixelPosition>& doubtful_;
  double margin_;
};

void FillTextured(const PixelPlane& plane, const PixelBounds& box,
                  const std::array<EdgeFunction, 3>& edges, const TexturedTriangle& triangle,
                  std::vector<PixelPosition>& doubtful) {
  const ValuePlanes places = value_planes(triangle.corners, triangle.coordinates, 1, box);
  const TexturedFill fill(plane, box, triangle, places, doubtful);
  walk_spans(edges, box, [&](int y, int first, int last) HWY_ATTR { fill.Span(y, first, last); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace edgecase
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace edgecase {

HWY_EXPORT(FillTextured);

void fill_textured_triangle(const PixelPlane& plane, const PixelBounds& bounds,
                            const TexturedTriangle& triangle, const TieWeights& ties,
                            std::vector<PixelPosition>& doubtful) {
  const auto& [a, b, c] = triangle.vertices;
  const TriangleSetup setup(a, b, c, ties);
  const PixelBounds box = common_part(setup.box_at(kCentrePlace), bounds);
  if (!setup.has_area() || is_empty(box)) return;
  HWY_DYNAMIC_DISPATCH(FillTextured)
  (plane, box, setup.edges_at(kCentrePlace), triangle, doubtful);
}

}  // namespace edgecase
#endif
