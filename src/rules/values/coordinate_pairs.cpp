// SPDX-License-Identifier: MIT
#include "rules/values/coordinate_pairs.h"

#include <algorithm>
#include <bit>
#include <type_traits>

namespace edgecase {

namespace {

constexpr std::size_t kRows = 4;  // those of a quad, and the rows beside it
constexpr std::size_t kMostColumns = 4096;

// Whether a derivative is more than the difference of two values, and how these are subtracted.
struct ExactArithmetic {
  static bool is_difference(const Interpolant& f, DerivativeMethod method) {
    return method != DerivativeMethod::analytic && !is_linear(f);
  }
  static constexpr auto derivative = derivative_exact;
  static Interval difference(Interval second, Interval first) { return second - first; }
};
struct InexactArithmetic {
  static bool is_difference(const Interpolant&, DerivativeMethod method) {
    return method != DerivativeMethod::analytic;
  }
  static constexpr auto derivative = derivative_inexact;
  static Interval difference(Interval second, Interval first) {
    return kInexact.subtract(second, first);
  }
};

template <class Place>
using ArithmeticOf =
    std::conditional_t<std::is_same_v<Place, ExactPlace>, ExactArithmetic, InexactArithmetic>;

}  // namespace

template <class Place>
CoordinatePairs<Place>::CoordinatePairs(int width)
    : columns_(std::min(std::bit_ceil(static_cast<std::size_t>(width)), kMostColumns)) {}

template <class Place>
Place CoordinatePairs<Place>::place_at(int primitive, const Interpolant& s, Point sample) {
  if constexpr (std::is_same_v<Place, InexactPlace>) {
    if (vertices_of_ != primitive) vertices_.emplace(s);
    vertices_of_ = primitive;
    return Place(sample, *vertices_);
  } else {
    return Place(sample);
  }
}

template <class Place>
std::array<Interval, 2> CoordinatePairs<Place>::at(int primitive, const Interpolant& s,
                                                   const Interpolant& t, PixelPosition pixel) {
  if (known_.empty()) known_.resize(kRows * columns_);
  // Neighbours of pixels at the target's edges lie outside it.
  const std::size_t column = static_cast<std::size_t>(pixel.x) % columns_;
  const std::size_t row = static_cast<std::size_t>(pixel.y) % kRows;
  AtPixel& known = known_[row * columns_ + column];
  if (known.primitive != primitive || known.pixel != pixel) {
    const Place place = place_at(primitive, s, pixel_centre(pixel.x, pixel.y));
    known = {primitive, pixel, {place.value(s), place.value(t)}};
  }
  return known.values;
}

template <class Place>
std::array<Interval, 2> CoordinatePairs<Place>::derivatives(int primitive, const Interpolant& s,
                                                            const Interpolant& t,
                                                            const QuadPixel& at, Axis axis,
                                                            DerivativeMethod method) {
  using Arithmetic = ArithmeticOf<Place>;
  if (!Arithmetic::is_difference(s, method) || !Arithmetic::is_difference(t, method))
    return {Arithmetic::derivative(s, at, axis, method),
            Arithmetic::derivative(t, at, axis, method)};
  const Neighbours of = neighbours_of(at, axis, method);
  const std::array<Interval, 2> first = this->at(primitive, s, t, of.first);
  const std::array<Interval, 2> second = this->at(primitive, s, t, of.second);
  return {Arithmetic::difference(second[0], first[0]), Arithmetic::difference(second[1], first[1])};
}

template class CoordinatePairs<ExactPlace>;
template class CoordinatePairs<InexactPlace>;

}  // namespace edgecase
