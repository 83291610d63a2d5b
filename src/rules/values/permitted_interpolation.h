// SPDX-License-Identifier: MIT
//
// The permitted half of rules/values/interpolation.h: what a primitive's attributes may be where
// each vertex may have moved.
//
// Of a triangle a mean's numerator and denominator are linear in each coordinate of a vertex, so
// the quotient is monotonic in each while the denominator keeps its sign: its extremes lie where
// every coordinate has moved as far as it may, at one of 64 corners. What a primitive's samples
// share is worked out once, by MovedVertices; what its attributes share at a sample, by
// MovedShares.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "rules/values/inexact_interpolation.h"

namespace edgecase {

// The vertices of one primitive, and the corners if it is a triangle.
class MovedVertices {
 public:
  // `primitive`: an attribute of it; its positions count. reach: each vertex may have moved by less
  // than this many pixels in x and in y.
  MovedVertices(const Interpolant& primitive, double reach);

  // Where each vertex may be.
  const WindowPlaces& grown() const { return grown_; }

 private:
  friend class MovedShares;

  static constexpr std::size_t kCorners = 64;
  // Of a vertex: bit 0 and 1 of its number tell whether x and y have grown. A corner's number has
  // those of the first vertex lowest.
  using Moved = std::array<WindowPlace, 4>;
  static std::size_t move_of(std::size_t corner, std::size_t vertex) {
    return corner >> 2 * vertex & 3;
  }

  void move_triangle(double reach);

  WindowPlaces unmoved_;
  WindowPlaces grown_;
  std::array<Moved, 3> moved_;
  Interval area_;                         // in inexact arithmetic, of the whole triangle
  std::array<Interval, kCorners> areas_;  // the same by corner
  bool is_steady_ = true;                 // all areas have one sign, exactly
  bool is_above_zero_ = false;            // and this is it
};

// The shares of a triangle's vertices at one sample, by corner.
//
// An area with a sample depends on two vertices alone, so there are 16 of each; areas belong to the
// corner and the sample, not to the attribute, and so do shares over w, since all attributes have
// one w. They are worked out once.
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

// What interpolate_permitted and differentiate_permitted yield for several attributes of one
// primitive at one sample. What the attributes share is worked out once.
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
