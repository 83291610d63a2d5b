// SPDX-License-Identifier: MIT
//
// The permitted part of rules/values/interpolation.h: the possible values of a primitive's
// attributes if each vertex may have moved.
//
// For a triangle, the numerator and denominator of a mean are linear in each coordinate of a
// vertex, so the quotient is monotonic in each while the denominator keeps its sign: its extremes
// are where every coordinate has moved as far as it may, at one of 64 corners. MovedVertices
// computes once the part that a primitive's samples share; MovedShares, the part that its
// attributes share at a sample.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "exact/interval.h"
#include "exact/interval_lanes.h"
#include "rules/values/inexact_interpolation.h"

namespace edgecase {

// The vertices of one primitive, and the corners if it is a triangle.
class MovedVertices {
 public:
  // `primitive`: one of its attributes, for its positions. reach: each vertex may have moved by
  // less than this many pixels in x and in y.
  MovedVertices(const Interpolant& primitive, double reach);

  // The possible positions of each vertex.
  const WindowPlaces& grown() const { return grown_; }
  // The growth of a triangle's shares along an axis; with perspective, over w. All attributes with
  // perspective must have the same w.
  const Shares& slopes(const Interpolant& f, Axis axis) const;

 private:
  friend class MovedShares;

  static constexpr std::size_t kCorners = 64;
  static constexpr std::size_t kEdges = 16;
  using Corners = IntervalLanes<kCorners>;
  using Edges = IntervalLanes<kEdges>;
  // One vertex: bits 0 and 1 of the index tell whether x and y have grown. A corner's index has
  // those of the first vertex lowest; an edge's, those of its first end.
  using Moved = std::array<WindowPlace, 4>;
  static std::size_t move_of(std::size_t corner, std::size_t vertex) {
    return corner >> 2 * vertex & 3;
  }
  // An edge's ends, by its moves.
  struct Edge {
    std::array<Edges, 2> from, to;
  };

  void move_triangle(double reach);

  WindowPlaces unmoved_;
  WindowPlaces grown_;
  std::array<Edge, 3> edges_;   // by the vertex opposite to each
  Interval area_;               // in inexact arithmetic, of the whole triangle
  Corners areas_;               // the same by corner
  Interval all_areas_;          // the hull of both
  bool is_steady_ = true;       // all areas have one sign, exactly
  bool is_above_zero_ = false;  // the sign, if they have one
  // By axis, computed on demand: as they are, and over w.
  mutable std::array<std::optional<Shares>, 2> slopes_;
  mutable std::array<std::optional<Shares>, 2> slopes_over_w_;
};

// The shares of a triangle's vertices at one sample, by corner.
//
// An area with a sample depends on two vertices alone, so there are 16 of each. Areas belong to the
// corner and the sample, not to the attribute, and so do shares over w, since all attributes have
// one w. They are computed once.
class MovedShares {
 public:
  // `vertices` must outlive this.
  MovedShares(const MovedVertices& vertices, Point sample);

  // interpolate_permitted for an attribute of that triangle. All attributes with perspective must
  // have the same w.
  Interval mean(const Interpolant& f) const;

  // The divisor of the mean, made of areas: the triangle's own or, with perspective, the sum of
  // those with the sample, each over its w. Everything if it may be 0.
  Interval total(const Interpolant& f) const;

 private:
  using Corners = MovedVertices::Corners;

  WeightsOf<Corners> areas(const Inexact& op) const;
  bool is_steady(const Interpolant& f) const;
  bool total_keeps_sign(const Interpolant& f) const;
  Interval total_over_w(const Interpolant& f) const;

  const MovedVertices& vertices_;
  WindowPlace sample_;
  WeightsOf<Corners> areas_;  // by the vertex opposite to each
  Shares unmoved_;
  WeightsOf<Corners> shares_;
  // For the one w, computed on demand.
  mutable std::optional<bool> total_keeps_sign_;
  mutable std::optional<SharesOverW> unmoved_over_w_;
  mutable std::optional<OverW<Corners>> over_w_;
  mutable std::optional<Interval> total_over_w_;
};

// The results of interpolate_permitted and differentiate_permitted for several attributes of one
// primitive at one sample. The part that the attributes share is computed once.
class PermittedPlace {
 public:
  // `vertices`, those of the attributes' primitive, must outlive this.
  PermittedPlace(const MovedVertices& vertices, Point sample)
      : vertices_(vertices), sample_(sample) {}

  // Attributes with perspective have the same w.
  Interval value(const Interpolant& f) const;
  Interval slope(const Interpolant& f, Axis axis) const;
  // Along x and along y; `value`: the result of value(f).
  std::array<Interval, 2> slopes(const Interpolant& f, Interval value) const;

 private:
  Interval slope(const Interpolant& f, Axis axis, Interval value) const;
  const MovedShares& shares() const;

  const MovedVertices& vertices_;
  Point sample_;
  mutable std::optional<MovedShares> shares_;  // for a triangle, computed on demand
};

}  // namespace edgecase
