// SPDX-License-Identifier: MIT
//
// What attributes are interpolated from: a primitive's own vertices, or where some of them lie
// outside the clip volume, three places of what is seen of a triangle
// (rules/values/clipped_interpolation), and the two ends of what is seen of a line.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "exact/interval.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "rules/values/clipped_interpolation.h"
#include "rules/values/interpolation.h"

namespace edgecase {

// Where a vertex is when its primitive's coverage is decided: snapped, as the choice says, and
// unsnapped ones exactly. Vertices of a clipped primitive are not snapped: those that clipping
// makes are, and they are not the vertices.
HomogeneousPoint snapped_position(const ScenePrimitive& primitive, std::size_t vertex,
                                  const CoverageChoice& choice, const Target& target);

class VertexAttributes {
 public:
  // Snapped positions are those of vertices alone: a clipped primitive's places stay.
  VertexAttributes(const ScenePrimitive& primitive, const RuleChoices& choices,
                   const Target& target);

  // Of one number at each vertex. Of a clipped primitive of which nothing is seen, an interpolant
  // without extent: its values may be any.
  Interpolant with_values(const std::array<double, 3>& values, bool perspective) const;
  // Window depth, 0 to 1, without a polygon offset.
  Interpolant depth() const;
  Interpolant inverse_w() const;  // 1/w

  // The same with all that the operations may err by which make them of clip coordinates (GL 4.6
  // core, 2.3.4.1): the division by w, the scaling and the addition of 13.8.1, and before these the
  // means of 13.7.1 where a vertex is one that clipping made.
  Interpolant permitted_depth() const;
  Interpolant permitted_inverse_w() const;

 private:
  Interpolant coordinate() const;
  Interval permitted_w(std::size_t vertex) const;

  const ScenePrimitive* primitive_;
  std::optional<ClippedPlane> plane_;
  std::optional<CutLine> cut_;
  Interpolant geometry_;  // everything but the values
};

}  // namespace edgecase
