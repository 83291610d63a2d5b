// SPDX-License-Identifier: MIT
#include "raster/texture_axis.h"

#include <algorithm>
#include <cmath>

#include "rules/textures/directed.h"

namespace edgecase {
namespace {

// From here on a double beside a number may lie in another texel.
constexpr int kFar = 1 << 20;
constexpr double kNarrow = 0x1p-40;

bool touches(Interval value, int size, TexelBorders borders) {
  const Interval scaled = value * (static_cast<double>(size) * borders.parts);
  return borders.parts > 0 && std::ceil(scaled.low) <= scaled.high;
}

// What is wider than rounding makes it is open as well.
bool is_open(Interval value, TexelBorders borders, std::span<const int> sizes) {
  if (!(value.high - value.low < kNarrow)) return true;
  return std::ranges::any_of(sizes, [&](int size) { return touches(value, size, borders); });
}

// Is a number on the lower side of the border that it is next to or on? `scaled`: times the borders
// there are from 0 to 1. None where it is an even multiple and no border.
std::optional<bool> is_below_border(const Rational& scaled, TexelBorders borders) {
  if (!borders.ties_to_even || !is_whole(scaled)) return (scaled - floor_of(scaled)) * 2 >= 1;
  if (is_whole(scaled / 2)) return std::nullopt;
  return is_whole((scaled - 1) / 4);
}

}  // namespace

TexelBorders texel_borders(Filter filter, TexelGrid grid, TextureFormat format) {
  const TexelBorders of_filter{filter == Filter::nearest ? 1 : 0, false};
  switch (grid) {
    case TexelGrid::none:
      return of_filter;
    case TexelGrid::floor_8:
      return {256, false};
    case TexelGrid::nearest_8:
      return {512, false};
    case TexelGrid::linear_even_8:
      return filter == Filter::linear && format == TextureFormat::rgba8 ? TexelBorders{512, true}
                                                                        : of_filter;
  }
  return of_filter;
}

const std::optional<RationalInterpolation>& TextureAxis::rational() {
  if (!rational_) rational_ = RationalInterpolation::of(coordinate_);
  return *rational_;
}

// Repetition has the period 1 or, mirrored, 2; what is clamped is so from the first texel beyond.
Rational TextureAxis::brought_near(const Rational& value) const {
  if (wrap_ == Wrap::repeat || wrap_ == Wrap::mirrored_repeat)
    return value - 2 * floor_of(value / 2);
  return value < 0 ? Rational(-1) : Rational(2);
}

// A double is its own place. Beside any other number lie two, and borders between them: the number
// is taken to be the one on its side.
Interval TextureAxis::decided(const Rational& value, TexelBorders borders,
                              std::span<const int> sizes) const {
  const Interval narrow = interval_of(value);
  if (narrow.low == narrow.high) return narrow;
  if (abs(value) >= kFar) return decided(brought_near(value), borders, sizes);
  for (const int size : sizes) {
    if (!touches(narrow, size, borders)) continue;
    const std::optional<bool> is_below = is_below_border(value * size * borders.parts, borders);
    if (is_below) return *is_below ? narrow.low : narrow.high;
  }
  return narrow;
}

Interval TextureAxis::place(Point sample, TexelBorders borders, std::span<const int> sizes,
                            const Rational& further) {
  const Interval narrow = exact_sum(value(sample), interval_of(further));
  if (!is_open(narrow, borders, sizes) || !rational()) return narrow;
  const std::optional<Rational> exact = rational()->at(sample);
  return exact ? decided(*exact + further, borders, sizes) : narrow;
}

std::optional<Rational> TextureAxis::derivative(const QuadPixel& at, Axis axis,
                                                DerivativeMethod method) {
  return rational() ? rational()->derivative(at, axis, method) : std::nullopt;
}

}  // namespace edgecase
