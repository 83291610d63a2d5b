// SPDX-License-Identifier: MIT
//
// An exact place: what interpolate_exact yields for several attributes of one primitive at one
// sample. What the attributes share is worked out once.
#pragma once

#include <array>
#include <optional>

#include "rules/values/interpolation.h"

namespace edgecase {

class ExactPlace {
 public:
  explicit ExactPlace(Point sample) : sample_(sample) {}

  // Attributes have the same vertices and line parameter; those that have perspective the same w.
  Interval value(const Interpolant& f) const;

 private:
  using Weights = std::array<Interval, 3>;
  bool has_extent(const Interpolant& f) const;
  const Weights& weights_of(const Interpolant& f) const;
  const Interval& total_of(const Interpolant& f) const;

  Point sample_;
  // When they are first asked for: whether the primitive has an extent, the weights as they are,
  // divided by w, and the sum of the former.
  mutable std::optional<bool> has_extent_;
  mutable std::optional<Weights> plain_;
  mutable std::optional<Weights> over_w_;
  mutable std::optional<Interval> total_;
};

}  // namespace edgecase
