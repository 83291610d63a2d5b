// SPDX-License-Identifier: MIT
//
// The attributes of primitives that leave the clip volume (GL 4.6 core, 13.7.1 and 14.6.1): those
// of a substitute for the visible part, each value an interval.
#pragma once

#include <array>
#include <optional>

#include "exact/homogeneous.h"
#include "exact/interval.h"
#include "model/scene.h"

namespace edgecase {

// The attributes of a clipped triangle (GL 4.6 core, 13.7.1 and 14.6.1), expressed as those of a
// substitute triangle in the same plane.
//
// A vertex behind the eye has no position in the window to interpolate from. But over the window an
// attribute over w, 1/w and the depth are linear, and a linear function is known from its values at
// any three points. These are chosen inside the visible part of the triangle, at multiples of
// 2^-16; the values there are quotients of integers, each enclosed in an interval.
class ClippedPlane {
 public:
  // None if nothing of the triangle is visible through its viewport, or nothing with an area.
  static std::optional<ClippedPlane> of(const ScenePrimitive& triangle);

  // The three points, with w at each, more than 0.
  const std::array<HomogeneousPoint, 3>& positions() const { return positions_; }
  const std::array<Interval, 3>& w() const { return w_; }
  // z/w at the points, -1 to 1 except for the rounding of the points.
  const std::array<Interval, 3>& depths() const { return depths_; }
  // The values of an attribute with perspective at the points; `values` are the vertices'.
  std::array<Interval, 3> smooth(const std::array<double, 3>& values) const;
  // The same without perspective; the vertices must lie in front of the eye.
  std::array<Interval, 3> noperspective(const std::array<double, 3>& values) const;

 private:
  // Each vertex' share at a point of the visible part, enclosed by neighbouring doubles: b_i of
  // rules/coverage/clip_volume.h over their sum, and b_i w_i.
  using Shares = std::array<Interval, 3>;
  std::array<HomogeneousPoint, 3> positions_{};
  std::array<Interval, 3> w_{};
  std::array<Interval, 3> depths_{};
  std::array<Shares, 3> shares_{};
  std::array<Shares, 3> window_shares_{};
};

// The attributes of a line that leaves the clip volume, at the ends of its visible part (GL 4.6
// core, 13.7.1): means of its vertices' values by the fraction of the way, each an interval that
// contains the quotient.
class CutLine {
 public:
  // None if nothing of the line is visible.
  static std::optional<CutLine> of(const ScenePrimitive& line);

  // For both ends; a third entry is 0, and for w it is 1.
  const std::array<Interval, 3>& w() const { return w_; }
  const std::array<Interval, 3>& depths() const { return depths_; }  // z/w, -1 to 1
  // An attribute with perspective at the ends; `values` are the vertices'.
  std::array<Interval, 3> smooth(const std::array<double, 3>& values) const;
  // The same without perspective; both vertices must lie in front of the eye.
  std::array<Interval, 3> noperspective(const std::array<double, 3>& values) const;

 private:
  using Shares = std::array<Interval, 3>;  // each vertex' share at an end; the third is 0
  std::array<Interval, 3> w_{1, 1, 1};
  std::array<Interval, 3> depths_{};
  std::array<Shares, 2> shares_{};
  std::array<Shares, 2> window_shares_{};
};

}  // namespace edgecase
