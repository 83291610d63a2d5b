// SPDX-License-Identifier: MIT
//
// What a clipped triangle carries (GL 4.6 core, 13.7.1 and 14.6.1): the attributes of a plane, as
// those of a triangle that stands for it.
//
// Behind the eye a vertex has no place in the window to interpolate from. Over the window, though,
// an attribute over w, 1/w and the depth are linear, and a linear function is known by its values
// at any three places. These are taken inside of what is seen of the triangle, at multiples of
// 2^-16, and the values there are quotients of integers, of which an interval holds each.
#pragma once

#include <array>
#include <optional>

#include "exact/homogeneous.h"
#include "exact/interval.h"
#include "model/scene.h"

namespace edgecase {

class ClippedPlane {
 public:
  // None where nothing of the triangle is seen through its viewport, or nothing with an area.
  static std::optional<ClippedPlane> of(const ScenePrimitive& triangle);

  // The three places, and w there, more than 0.
  const std::array<HomogeneousPoint, 3>& positions() const { return positions_; }
  const std::array<Interval, 3>& w() const { return w_; }
  // z/w there, -1 to 1 but for the rounding of the places.
  const std::array<Interval, 3>& depths() const { return depths_; }
  // There, an attribute that is interpolated with perspective; `values` are the vertices'.
  std::array<Interval, 3> smooth(const std::array<double, 3>& values) const;
  // Without; its vertices must lie in front of the eye.
  std::array<Interval, 3> noperspective(const std::array<double, 3>& values) const;

 private:
  // Each vertex' share in what is seen at a place, doubles' neighbours around a quotient: b_i of
  // rules/coverage/clip_volume.h over their sum, and b_i w_i.
  using Shares = std::array<Interval, 3>;
  std::array<HomogeneousPoint, 3> positions_{};
  std::array<Interval, 3> w_{};
  std::array<Interval, 3> depths_{};
  std::array<Shares, 3> shares_{};
  std::array<Shares, 3> window_shares_{};
};

// ------------------------------------------------------------------------------------------- lines
//
// What a line that leaves the clip volume carries at the ends of what is seen of it (GL 4.6
// core, 13.7.1): means of its vertices' values by the part of the way, each an interval that holds
// the quotient.

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
