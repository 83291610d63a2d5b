// SPDX-License-Identifier: MIT
//
// What a line that leaves the clip volume carries at the ends of what is seen of it (GL 4.6
// core, 13.7.1): means of its vertices' values by the part of the way, each an interval that holds
// the quotient.
#pragma once

#include <array>
#include <optional>

#include "exact/interval.h"
#include "model/scene.h"

namespace edgecase {

class CutLine {
 public:
  // None where nothing of the line is seen.
  static std::optional<CutLine> of(const ScenePrimitive& line);

  // Of both ends; a third entry stays 0, and a w 1.
  const std::array<Interval, 3>& w() const { return w_; }
  const std::array<Interval, 3>& depths() const { return depths_; }  // z/w, -1 to 1
  // An attribute that is interpolated with perspective; `values` are the vertices'.
  std::array<Interval, 3> smooth(const std::array<double, 3>& values) const;
  // Without; both vertices must lie in front of the eye.
  std::array<Interval, 3> noperspective(const std::array<double, 3>& values) const;

 private:
  // Each vertex' share in an end.
  using Shares = std::array<Interval, 2>;
  std::array<Interval, 3> w_{1, 1, 1};
  std::array<Interval, 3> depths_{};
  std::array<Shares, 2> shares_{};
  std::array<Shares, 2> window_shares_{};
};

}  // namespace edgecase
