// SPDX-License-Identifier: MIT
//
// Moved vertices: what a primitive's attributes may be where each vertex may have moved.
//
// Of a triangle a mean's numerator and denominator are linear in each coordinate of a vertex, so
// the quotient is monotonic in each while the denominator keeps its sign: its extremes lie where
// every coordinate has moved as far as it may, at one of 64 corners. An area with a sample depends
// on two vertices alone, so there are 16 of each; and areas belong to the corner and the sample,
// not to the attribute. What is shared is worked out once: for a primitive here, for a sample in
// MovedShares.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "rules/values/inexact_shares.h"

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

  const MovedVertices& vertices_;
  WindowPlace sample_;
  Areas areas_;
  Shares unmoved_;
  std::array<Shares, MovedVertices::kCorners> shares_;
  mutable std::optional<bool> total_keeps_sign_;
};

}  // namespace edgecase
