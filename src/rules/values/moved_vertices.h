// SPDX-License-Identifier: MIT
//
// Moved vertices: what a primitive's attributes may be where each vertex may have moved.
//
// Of a triangle a mean's numerator and denominator are linear in each coordinate of a vertex, so
// the quotient is monotonic in each while the denominator keeps its sign: its extremes lie where
// every coordinate has moved as far as it may, at one of 64 corners. What a primitive's samples
// share is worked out once, here; what its attributes share at a sample, in
// rules/values/moved_shares.h.
#pragma once

#include <array>
#include <cstddef>

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

}  // namespace edgecase
