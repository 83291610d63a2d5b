// SPDX-License-Identifier: MIT
#include "rules/values/permitted_interpolation.h"

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

// ------------------------------------------------------------------------------------ moved shares

MovedShares::MovedShares(const MovedVertices& vertices, Point sample)
    : vertices_(vertices), sample_(place_of(sample)) {
  if (!vertices_.is_steady_) return;
  unmoved_ = triangle_shares(vertices_.unmoved_, sample_);
  areas_ = areas(kInexact);
  for (std::size_t corner = 0; corner < MovedVertices::kCorners; ++corner)
    for (std::size_t i = 0; i < 3; ++i)
      shares_[corner][i] = kInexact.divide(areas_[i][edge_of(corner, i)], vertices_.areas_[corner]);
}

std::size_t MovedShares::edge_of(std::size_t corner, std::size_t opposite) {
  const std::size_t from = next(opposite);
  return MovedVertices::move_of(corner, from) | MovedVertices::move_of(corner, next(from)) << 2;
}

MovedShares::Areas MovedShares::areas(const Inexact& op) const {
  Areas result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = next(i);
    for (std::size_t edge = 0; edge < 16; ++edge)
      result[i][edge] = area_of(op, vertices_.moved_[from][edge & 3],
                                vertices_.moved_[next(from)][edge >> 2], sample_);
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
  const auto is_above_zero = [&](const std::array<Interval, 3>& a) {
    return (a[0] / f.w[0] + a[1] / f.w[1] + a[2] / f.w[2]).low > 0;
  };
  const WindowPlaces& v = vertices_.unmoved_;
  const bool unmoved =
      is_above_zero({area_of(kExactly, v[1], v[2], sample_), area_of(kExactly, v[2], v[0], sample_),
                     area_of(kExactly, v[0], v[1], sample_)});
  const Areas exact = areas(kExactly);
  for (std::size_t corner = 0; corner < MovedVertices::kCorners; ++corner)
    if (is_above_zero({exact[0][edge_of(corner, 0)], exact[1][edge_of(corner, 1)],
                       exact[2][edge_of(corner, 2)]}) != unmoved)
      return false;
  return true;
}

const std::vector<SharesOverW>& MovedShares::over_w(const Interpolant& f) const {
  if (!over_w_.empty()) return over_w_;
  over_w_.reserve(1 + shares_.size());
  over_w_.push_back(divided_by_w(f, unmoved_));
  for (const Shares& shares : shares_) over_w_.push_back(divided_by_w(f, shares));
  return over_w_;
}

Interval MovedShares::mean(const Interpolant& f) const {
  if (!is_steady(f)) return Interval::everything();
  if (has_perspective(f)) {
    const std::vector<SharesOverW>& all = over_w(f);
    Interval result = inexact_mean(f, all.front());
    for (const SharesOverW& shares : all) result = hull(result, inexact_mean(f, shares));
    return result;
  }
  Interval result = inexact_mean(f, unmoved_);
  for (const Shares& shares : shares_) result = hull(result, inexact_mean(f, shares));
  return result;
}

Interval MovedShares::total(const Interpolant& f) const {
  if (!is_steady(f)) return Interval::everything();
  if (!has_perspective(f)) return plain_total();
  if (!total_over_w_) total_over_w_ = total_over_w(f);
  return *total_over_w_;
}

Interval MovedShares::plain_total() const {
  Interval result = vertices_.area_;
  for (const Interval area : vertices_.areas_) result = hull(result, area);
  return result;
}

Interval MovedShares::total_over_w(const Interpolant& f) const {
  const WindowPlaces& v = vertices_.unmoved_;
  Interval result = divided_by_w(f, {area_of(kInexact, v[1], v[2], sample_),
                                     area_of(kInexact, v[2], v[0], sample_),
                                     area_of(kInexact, v[0], v[1], sample_)})
                        .total;
  for (std::size_t corner = 0; corner < MovedVertices::kCorners; ++corner)
    result =
        hull(result, divided_by_w(f, {areas_[0][edge_of(corner, 0)], areas_[1][edge_of(corner, 1)],
                                      areas_[2][edge_of(corner, 2)]})
                         .total);
  return result;
}

// --------------------------------------------------------------------------------- permitted place

Interval PermittedPlace::value(const Interpolant& f) const {
  switch (f.kind) {
    case PrimitiveKind::point:
      return point_value(f);
    case PrimitiveKind::line:
      return inexact_mean(f, line_shares(f, vertices_.grown(), place_of(sample_)));
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
  const WindowPlaces& v = vertices_.grown();
  if (f.kind == PrimitiveKind::line) return line_slope(f, v, place_of(sample_), axis);
  return triangle_slope(f, v, axis, value, shares().total(f));
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
