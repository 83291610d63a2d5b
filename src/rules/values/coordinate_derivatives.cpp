// SPDX-License-Identifier: MIT
#include "rules/values/coordinate_derivatives.h"

#include <algorithm>
#include <bit>

#include "rules/values/exact_place.h"
#include "rules/values/inexact_place.h"

namespace edgecase {
namespace {

constexpr std::size_t kRows = 4;  // a quad's, and those beside it
constexpr std::size_t kMostColumns = 4096;

Point centre_of(PixelPosition pixel) {
  return pixel_centre(pixel.x, pixel.y);
}

}  // namespace

std::array<Interval, 2> derivatives_exact(const Interpolant& s, const Interpolant& t,
                                          const QuadPixel& at, Axis axis, DerivativeMethod method) {
  if (method == DerivativeMethod::analytic || is_linear(s) || is_linear(t))
    return {derivative_exact(s, at, axis, method), derivative_exact(t, at, axis, method)};
  const Neighbours of = neighbours_of(at, axis, method);
  const ExactPlace first(centre_of(of.first)), second(centre_of(of.second));
  return {second.value(s) - first.value(s), second.value(t) - first.value(t)};
}

InexactDerivatives::InexactDerivatives(int width)
    : columns_(std::min(std::bit_ceil(static_cast<std::size_t>(width)), kMostColumns)) {}

const InexactDerivatives::AtPixel& InexactDerivatives::at_pixel(int primitive, const Interpolant& s,
                                                                const Interpolant& t,
                                                                PixelPosition pixel) {
  if (known_.empty()) known_.resize(kRows * columns_);
  // Neighbours of pixels at the target's edges lie outside it.
  const std::size_t column = static_cast<std::size_t>(pixel.x) % columns_;
  const std::size_t row = static_cast<std::size_t>(pixel.y) % kRows;
  AtPixel& known = known_[row * columns_ + column];
  if (known.primitive != primitive || known.pixel != pixel) {
    const InexactPlace place(centre_of(pixel));
    known = {primitive, pixel, {place.value(s), place.value(t)}};
  }
  return known;
}

std::array<Interval, 2> InexactDerivatives::at(int primitive, const Interpolant& s,
                                               const Interpolant& t, const QuadPixel& at, Axis axis,
                                               DerivativeMethod method) {
  if (method == DerivativeMethod::analytic)
    return {derivative_inexact(s, at, axis, method), derivative_inexact(t, at, axis, method)};
  const Neighbours of = neighbours_of(at, axis, method);
  const std::array<Interval, 2> first = at_pixel(primitive, s, t, of.first).values;
  const std::array<Interval, 2>& second = at_pixel(primitive, s, t, of.second).values;
  return {kInexact.subtract(second[0], first[0]), kInexact.subtract(second[1], first[1])};
}

}  // namespace edgecase
