// SPDX-License-Identifier: MIT
#include "rules/values/interpolation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rules/coverage/homogeneous_line.h"
#include "rules/values/inexact_interpolation.h"

namespace edgecase {

bool has_extent(const Interpolant& f) {
  if (f.kind == PrimitiveKind::triangle)
    return cross(f.positions[0], f.positions[1], f.positions[2]) != 0;
  return !same_point(f.positions[0], f.positions[1]);
}

namespace {

// True if these are the same number at all vertices.
bool is_one_number(const Interpolant& f, const std::array<Interval, 3>& numbers) {
  return std::all_of(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count_of(f)),
                     [&](Interval number) {
                       return number.low == numbers[0].low && number.high == numbers[0].high;
                     });
}

}  // namespace

bool is_constant(const Interpolant& f) {
  return is_one_number(f, f.values);
}

bool has_perspective(const Interpolant& f) {
  return f.perspective && !is_one_number(f, f.w);
}

bool is_linear(const Interpolant& f) {
  return is_constant(f) || !has_perspective(f);
}

bool is_x_major(const Interpolant& line) {
  return HomogeneousSegment{line.positions[0], line.positions[1]}.x_major();
}

bool goes_by_x(const Interpolant& line) {
  return is_x_major(line) == (line.line_parameter == LineParameter::major_axis);
}

bool may_swap_axes(const Interpolant& line, double reach) {
  const WindowPlaces v = places_of(line);
  const double dx = (v[1][0] - v[0][0]).magnitude();
  const double dy = (v[1][1] - v[0][1]).magnitude();
  return std::fabs(dx - dy) <= 4 * reach;
}

Interpolant over_w(Interpolant f) {
  for (std::size_t i = 0; i < count_of(f); ++i) f.values[i] = f.values[i] / f.w[i];
  f.perspective = false;
  return f;
}

Interpolant inverse_w(Interpolant f) {
  for (std::size_t i = 0; i < count_of(f); ++i) f.values[i] = Interval(1) / f.w[i];
  f.perspective = false;
  return f;
}

}  // namespace edgecase
