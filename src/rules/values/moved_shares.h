// SPDX-License-Identifier: MIT
//
// Moved shares: the mean of an attribute at a sample, where each vertex of the triangle may have
// moved (rules/values/moved_vertices.h).
//
// An area with a sample depends on two vertices alone, so there are 16 of each; areas belong to the
// corner and the sample, not to the attribute, and so do shares over w, since all attributes have
// one w. They are worked out once.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "rules/values/inexact_shares.h"
#include "rules/values/moved_vertices.h"

namespace edgecase {

// The shares of a triangle's vertices at one sample, by corner.
class MovedShares {
 public:
  // `vertices` must outlive this.
  MovedShares(const MovedVertices& vertices, Point sample);

  // interpolate_permitted of an attribute of that triangle. All attributes that are asked for with
  // perspective have the same w.
  Interval mean(const Interpolant& f) const;

  // What the mean is divided by, made of areas: the triangle's own, or with perspective the sum of
  // those with the sample, each over its w. Everything where it may be 0.
  Interval total(const Interpolant& f) const;

 private:
  // By the vertex that an area's edge lies opposite to, and the moves of the next vertex and of the
  // one after it.
  using Areas = std::array<std::array<Interval, 16>, 3>;

  static std::size_t edge_of(std::size_t corner, std::size_t opposite);
  Areas areas(const Inexact& op) const;
  bool is_steady(const Interpolant& f) const;
  bool total_keeps_sign(const Interpolant& f) const;
  const std::vector<SharesOverW>& over_w(const Interpolant& f) const;
  Interval plain_total() const;
  Interval total_over_w(const Interpolant& f) const;

  const MovedVertices& vertices_;
  WindowPlace sample_;
  Areas areas_;
  Shares unmoved_;
  std::array<Shares, MovedVertices::kCorners> shares_;
  // Of the one w, when they are first asked for.
  mutable std::optional<bool> total_keeps_sign_;
  mutable std::vector<SharesOverW> over_w_;  // of the unmoved vertices, and by corner
  mutable std::optional<Interval> total_over_w_;
};

}  // namespace edgecase
