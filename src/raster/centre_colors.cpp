// SPDX-License-Identifier: MIT
#include "raster/centre_colors.h"

#include <algorithm>
#include <bit>
#include <functional>

#include "raster/attributes.h"
#include "rules/values/exact_place.h"

namespace edgecase {
namespace {

constexpr std::size_t kRows = 4;  // a quad's, and those beside it
constexpr std::size_t kMostColumns = 4096;

void take_middles(CentreColors::Derivatives& derivatives) {
  std::ranges::transform(derivatives.exact, derivatives.middles.begin(), middle);
}

}  // namespace

CentreColors::CentreColors(int width)
    : columns_(std::min(std::bit_ceil(static_cast<std::size_t>(width)), kMostColumns)) {}

void CentreColors::take(const std::array<Interpolant, 4>& components) {
  components_ = &components;
  std::ranges::transform(components, are_linear_.begin(), is_linear);
  for (const Axis axis : {Axis::x, Axis::y}) {
    Derivatives& slopes = slopes_[static_cast<std::size_t>(axis)];
    for (std::size_t c = 0; c < components.size(); ++c)
      if (are_linear_[c]) slopes.exact[c] = differentiate_exact(components[c], Point{}, axis);
    take_middles(slopes);
  }
  ++primitive_;
}

// Neighbours of pixels at the target's edges lie outside it.
std::size_t CentreColors::place_of(PixelPosition pixel) const {
  const std::size_t column = static_cast<std::size_t>(pixel.x) % columns_;
  const std::size_t row = static_cast<std::size_t>(pixel.y) % kRows;
  return row * columns_ + column;
}

const CentreColors::Components& CentreColors::at(PixelPosition pixel) {
  if (known_.empty()) known_.resize(kRows * columns_);
  AtPixel& known = known_[place_of(pixel)];
  if (known.primitive != primitive_ || known.pixel != pixel) {
    const ExactPlace place(pixel_centre(pixel.x, pixel.y));
    known.primitive = primitive_;
    known.pixel = pixel;
    std::ranges::transform(*components_, known.values.begin(),
                           [&](const Interpolant& f) { return place.value(f); });
  }
  return known.values;
}

CentreColors::Components CentreColors::difference(const Neighbours& of, Axis axis) {
  // Copied: a narrow target's neighbours may be kept in one place.
  const Components first = at(of.first);
  const Components& second = at(of.second);
  Components result = slopes_[static_cast<std::size_t>(axis)].exact;
  for (std::size_t c = 0; c < result.size(); ++c)
    if (!are_linear_[c]) result[c] = second[c] - first[c];
  return result;
}

const CentreColors::Derivatives& CentreColors::derivatives(const QuadPixel& pixel, Axis axis,
                                                           DerivativeMethod method) {
  if (std::ranges::all_of(are_linear_, std::identity()))
    return slopes_[static_cast<std::size_t>(axis)];
  if (method == DerivativeMethod::analytic) {
    std::ranges::transform(*components_, analytic_.exact.begin(), [&](const Interpolant& f) {
      return derivative_exact(f, pixel, axis, method);
    });
    take_middles(analytic_);
    return analytic_;
  }
  std::vector<AtNeighbours>& differences = differences_[static_cast<std::size_t>(axis)];
  if (differences.empty()) differences.resize(kRows * columns_);
  const Neighbours of = neighbours_of(pixel, axis, method);
  AtNeighbours& known = differences[place_of(of.first)];
  if (known.primitive != primitive_ || known.pixels != of) {
    known.primitive = primitive_;
    known.pixels = of;
    known.derivatives.exact = difference(of, axis);
    take_middles(known.derivatives);
  }
  return known.derivatives;
}

}  // namespace edgecase
