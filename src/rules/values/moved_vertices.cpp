// SPDX-License-Identifier: MIT
#include "rules/values/moved_vertices.h"

namespace edgecase {
namespace {

// Without the clause: wide by the rounding of doubles alone.
constexpr Inexact kExactly{0};

}  // namespace

MovedVertices::MovedVertices(const Interpolant& primitive, double reach)
    : unmoved_(places_of(primitive)), grown_(unmoved_) {
  for (WindowPlace& place : grown_)
    for (Interval& axis : place) axis = axis + Interval(-reach, reach);
  if (primitive.kind == PrimitiveKind::triangle) move_triangle(reach);
}

void MovedVertices::move_triangle(double reach) {
  for (std::size_t vertex = 0; vertex < 3; ++vertex)
    for (std::size_t move = 0; move < 4; ++move)
      for (std::size_t axis = 0; axis < 2; ++axis)
        moved_[vertex][move][axis] =
            unmoved_[vertex][axis] + ((move >> axis & 1U) != 0 ? reach : -reach);
  const auto area = [](const Inexact& op, const WindowPlace& a, const WindowPlace& b,
                       const WindowPlace& c) { return area_of(op, b, c, a); };
  area_ = area(kInexact, unmoved_[0], unmoved_[1], unmoved_[2]);
  is_above_zero_ = area(kExactly, unmoved_[0], unmoved_[1], unmoved_[2]).low > 0;
  for (std::size_t corner = 0; corner < kCorners; ++corner) {
    const WindowPlace& a = moved_[0][move_of(corner, 0)];
    const WindowPlace& b = moved_[1][move_of(corner, 1)];
    const WindowPlace& c = moved_[2][move_of(corner, 2)];
    areas_[corner] = area(kInexact, a, b, c);
    if ((area(kExactly, a, b, c).low > 0) != is_above_zero_) is_steady_ = false;
  }
}

}  // namespace edgecase
