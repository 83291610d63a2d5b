// SPDX-License-Identifier: MIT
#include "raster/texture_axis.h"

#include <algorithm>
#include <cmath>

namespace edgecase {
namespace {

// From here on a double beside a number may lie in another texel.
constexpr int kFar = 1 << 20;
constexpr double kNarrow = 0x1p-40;

// Of 0 or more, whatever the sign of the value.
Integer modulo(const Integer& value, int by) {
  const Integer rest = value % by;
  return rest < 0 ? Integer(rest + by) : rest;
}

bool holds_whole(Interval value) {
  return std::ceil(value.low) <= value.high;
}

Interval times_borders(Interval value, int size, TexelBorders borders) {
  return value * (static_cast<double>(size) * borders.parts);
}

// Is a number on the lower side of the border nearest to it? `scaled`: times the borders there are
// from 0 to 1.
bool is_below_border(const Rational& scaled, TexelBorders borders) {
  const Integer below = floor_of(scaled);
  if (borders.ties_to_even && scaled == below) return modulo(below, 4) == 1;
  return (scaled - below) * 2 >= 1;
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

TextureAxis::TextureAxis(const Interpolant& coordinate, Wrap wrap, const std::vector<int>& sizes)
    : coordinate_(coordinate), wrap_(wrap) {
  // The borders of a size are among those of its multiples.
  for (const int size : sizes) {
    const bool is_covered =
        std::any_of(sizes_.begin(), sizes_.end(), [&](int other) { return other % size == 0; });
    if (!is_covered) sizes_.push_back(size);
  }
}

const std::optional<RationalInterpolation>& TextureAxis::rational() {
  if (!is_known_) rational_ = RationalInterpolation::of(coordinate_);
  is_known_ = true;
  return rational_;
}

// What is wider than rounding makes it is open as well.
bool TextureAxis::is_open(Interval value, TexelBorders borders) const {
  if (!(value.high - value.low < kNarrow)) return true;
  return borders.parts > 0 && std::any_of(sizes_.begin(), sizes_.end(), [&](int size) {
           return holds_whole(times_borders(value, size, borders));
         });
}

// Repetition has the period 1 or, mirrored, 2; what is clamped is so from the first texel beyond.
Rational TextureAxis::brought_near(const Rational& value) const {
  if (wrap_ == Wrap::repeat || wrap_ == Wrap::mirrored_repeat)
    return value - 2 * floor_of(value / 2);
  return value < 0 ? Rational(-1) : Rational(2);
}

// A double is its own place. Beside any other number lie two, and borders between them: the number
// is taken to be the one on its side.
Interval TextureAxis::decided(const Rational& value, TexelBorders borders) const {
  const Interval narrow = interval_of(value);
  if (narrow.low == narrow.high) return narrow;
  if (abs(value) >= kFar) return decided(brought_near(value), borders);
  if (borders.parts == 0) return narrow;
  for (const int size : sizes_) {
    if (!holds_whole(times_borders(narrow, size, borders))) continue;
    const Rational scaled = value * size * borders.parts;
    return is_below_border(scaled, borders) ? narrow.low : narrow.high;
  }
  return narrow;
}

Interval TextureAxis::place(Point sample, TexelBorders borders) {
  const Interval narrow = value(sample);
  if (!is_open(narrow, borders) || !rational()) return narrow;
  const std::optional<Rational> exact = rational()->at(sample);
  return exact ? decided(*exact, borders) : narrow;
}

Interval TextureAxis::place(Point sample, TexelBorders borders, const Rational& further) {
  const Interval narrow = value(sample) + interval_of(further);
  if (!is_open(narrow, borders) || !rational()) return narrow;
  const std::optional<Rational> exact = rational()->at(sample);
  return exact ? decided(*exact + further, borders) : narrow;
}

std::optional<Rational> TextureAxis::derivative(const QuadPixel& at, Axis axis,
                                                DerivativeMethod method) {
  return rational() ? rational()->derivative(at, axis, method) : std::nullopt;
}

}  // namespace edgecase
