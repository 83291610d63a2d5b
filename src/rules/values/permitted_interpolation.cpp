// SPDX-License-Identifier: MIT
#include "rules/values/permitted_interpolation.h"

#include <algorithm>
#include <cstddef>

namespace edgecase {
namespace {

// Without the clause: as wide as the rounding of doubles alone.
constexpr Inexact kExactly{0};

std::size_t next(std::size_t vertex) {
  return (vertex + 1) % 3;
}

}  // namespace

MovedVertices::MovedVertices(const Interpolant& primitive, double reach)
    : unmoved_(places_of(primitive)), grown_(unmoved_) {
  for (WindowPlace& place : grown_)
    for (Interval& axis : place) axis = axis + Interval(-reach, reach);
  if (primitive.kind == PrimitiveKind::triangle) move_triangle(reach);
}

void MovedVertices::move_triangle(double reach) {
  std::array<Moved, 3> moved;
  for (std::size_t vertex = 0; vertex < 3; ++vertex)
    for (std::size_t move = 0; move < 4; ++move)
      for (std::size_t axis = 0; axis < 2; ++axis)
        moved[vertex][move][axis] =
            unmoved_[vertex][axis] + ((move >> axis & 1U) != 0 ? reach : -reach);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t edge = 0; edge < kEdges; ++edge)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        edges_[i].from[axis].set(edge, moved[next(i)][edge & 3][axis]);
        edges_[i].to[axis].set(edge, moved[next(next(i))][edge >> 2][axis]);
      }
  const auto area = [](const Inexact& op, const WindowPlace& a, const WindowPlace& b,
                       const WindowPlace& c) { return area_of(op, b, c, a); };
  area_ = area(kInexact, unmoved_[0], unmoved_[1], unmoved_[2]);
  is_above_zero_ = area(kExactly, unmoved_[0], unmoved_[1], unmoved_[2]).low > 0;
  for (std::size_t corner = 0; corner < kCorners; ++corner) {
    const WindowPlace& a = moved[0][move_of(corner, 0)];
    const WindowPlace& b = moved[1][move_of(corner, 1)];
    const WindowPlace& c = moved[2][move_of(corner, 2)];
    areas_.set(corner, area(kInexact, a, b, c));
    if ((area(kExactly, a, b, c).low > 0) != is_above_zero_) is_steady_ = false;
  }
  all_areas_ = hull(area_, hull_of(areas_));
}

const Shares& MovedVertices::slopes(const Interpolant& f, Axis axis) const {
  const std::size_t along = axis == Axis::x ? 0 : 1;
  std::optional<Shares>& plain = slopes_[along];
  if (!plain) plain = area_slopes(grown_, axis);
  if (!has_perspective(f)) return *plain;
  std::optional<Shares>& over_w = slopes_over_w_[along];
  if (!over_w) over_w = divided_by_w(kInexact, *plain, f.w, 3);
  return *over_w;
}

MovedShares::MovedShares(const MovedVertices& vertices, Point sample)
    : vertices_(vertices), sample_(place_of(sample)) {
  if (!vertices_.is_steady_) return;
  unmoved_ = triangle_shares(vertices_.unmoved_, vertices_.area_, sample_);
  areas_ = areas(kInexact);
  for (std::size_t i = 0; i < 3; ++i) shares_[i] = kInexact.divide(areas_[i], vertices_.areas_);
}

WeightsOf<MovedShares::Corners> MovedShares::areas(const Inexact& op) const {
  WeightsOf<Corners> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [from, to] = vertices_.edges_[i];
    const MovedVertices::Edges of_edges = area_of(op, from, to, sample_);
    for (std::size_t corner = 0; corner < MovedVertices::kCorners; ++corner) {
      const std::size_t edge = MovedVertices::move_of(corner, next(i)) |
                               MovedVertices::move_of(corner, next(next(i))) << 2;
      result[i].set(corner, of_edges[edge]);
    }
  }
  return result;
}

// False if a divisor may be 0 at a corner or change its sign between corners; then everything is
// permitted.
bool MovedShares::is_steady(const Interpolant& f) const {
  if (!vertices_.is_steady_) return false;
  if (!has_perspective(f)) return true;
  if (!total_keeps_sign_) total_keeps_sign_ = total_keeps_sign(f);
  return *total_keeps_sign_;
}

bool MovedShares::total_keeps_sign(const Interpolant& f) const {
  const auto total_of = [&](const auto& areas) {
    const auto over_w = divided_by_w(kOwnOperators, areas, f.w, 3);
    return add_weights(kOwnOperators, over_w[0], over_w, 1, 3);
  };
  const Shares unmoved = areas_at(kExactly, vertices_.unmoved_, sample_);
  const bool is_above_zero = total_of(unmoved).low > 0;
  return std::ranges::all_of(total_of(areas(kExactly)).low,
                             [&](double low) { return (low > 0) == is_above_zero; });
}

Interval MovedShares::mean(const Interpolant& f) const {
  if (!is_steady(f)) return Interval::everything();
  if (!has_perspective(f)) return hull(inexact_mean(f, unmoved_), hull_of(inexact_sum(f, shares_)));
  if (!over_w_) {
    unmoved_over_w_ = divided_by_w(f, unmoved_);
    over_w_ = divided_by_w(f, shares_);
  }
  return hull(inexact_mean(f, *unmoved_over_w_), hull_of(inexact_mean(f, *over_w_)));
}

Interval MovedShares::total(const Interpolant& f) const {
  if (!is_steady(f)) return Interval::everything();
  if (!has_perspective(f)) return vertices_.all_areas_;
  if (!total_over_w_) total_over_w_ = total_over_w(f);
  return *total_over_w_;
}

Interval MovedShares::total_over_w(const Interpolant& f) const {
  const Shares unmoved = areas_at(kInexact, vertices_.unmoved_, sample_);
  return hull(divided_by_w(f, unmoved).total, hull_of(divided_by_w(f, areas_).total));
}

Interval PermittedPlace::value(const Interpolant& f) const {
  switch (f.kind) {
    case PrimitiveKind::point:
      return inexact_at_point(f);
    case PrimitiveKind::line:
      return inexact_mean(f, line_weights(kInexact, f, vertices_.grown(), place_of(sample_)));
    case PrimitiveKind::triangle:
      return shares().mean(f);
  }
  return Interval::everything();
}

Interval PermittedPlace::slope(const Interpolant& f, Axis axis) const {
  return slope(f, axis, f.kind == PrimitiveKind::triangle && has_perspective(f) ? value(f) : 0);
}

std::array<Interval, 2> PermittedPlace::slopes(const Interpolant& f, Interval value) const {
  return {slope(f, Axis::x, value), slope(f, Axis::y, value)};
}

Interval PermittedPlace::slope(const Interpolant& f, Axis axis, Interval value) const {
  if (f.kind == PrimitiveKind::point) return 0;
  if (f.kind == PrimitiveKind::line)
    return line_slope(f, vertices_.grown(), place_of(sample_), axis);
  return triangle_slope(f, vertices_.slopes(f, axis), value, shares().total(f));
}

const MovedShares& PermittedPlace::shares() const {
  if (!shares_) shares_.emplace(vertices_, sample_);
  return *shares_;
}

Interval interpolate_permitted(const Interpolant& f, Point sample, double reach) {
  const MovedVertices vertices(f, reach);
  return PermittedPlace(vertices, sample).value(f);
}

Interval differentiate_permitted(const Interpolant& f, Point sample, Axis axis, double reach) {
  const MovedVertices vertices(f, reach);
  return PermittedPlace(vertices, sample).slope(f, axis);
}

}  // namespace edgecase
