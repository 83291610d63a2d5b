// SPDX-License-Identifier: MIT
#include "rules/values/moved_shares.h"

namespace edgecase {
namespace {

// Without the clause: wide by the rounding of doubles alone.
constexpr Inexact kExactly{0};

std::size_t next(std::size_t vertex) {
  return (vertex + 1) % 3;
}

}  // namespace

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

// What may be 0 at a corner is divided by there, and yields everything; so may what changes its
// sign between corners.
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

}  // namespace edgecase
