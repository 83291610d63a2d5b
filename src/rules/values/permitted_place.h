// SPDX-License-Identifier: MIT
//
// A permitted place: what interpolate_permitted and differentiate_permitted yield for several
// attributes of one primitive at one sample. What the attributes share is worked out once.
#pragma once

#include <array>
#include <optional>

#include "rules/values/moved_shares.h"

namespace edgecase {

class PermittedPlace {
 public:
  // `vertices`, of the primitive that the attributes belong to, must outlive this.
  PermittedPlace(const MovedVertices& vertices, Point sample)
      : vertices_(vertices), sample_(sample) {}

  // Attributes that have perspective have the same w.
  Interval value(const Interpolant& f) const;
  Interval slope(const Interpolant& f, Axis axis) const;
  // Along x and along y; `value`: what value(f) is.
  std::array<Interval, 2> slopes(const Interpolant& f, Interval value) const;

 private:
  Interval slope(const Interpolant& f, Axis axis, Interval value) const;
  const MovedShares& shares() const;

  const MovedVertices& vertices_;
  Point sample_;
  mutable std::optional<MovedShares> shares_;  // of a triangle, when it is first asked for
};

}  // namespace edgecase
