// SPDX-License-Identifier: MIT
//
// The vertices from which attributes are interpolated: a primitive's own or, if some lie outside
// the clip volume, three points of the visible part of a triangle
// (rules/values/clipped_interpolation) or the two ends of the visible part of a line.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "exact/interval.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "rules/values/interpolation.h"

namespace edgecase {

// A vertex's position for its primitive's coverage: snapped as the choice says, or exact. Vertices
// of a clipped primitive are not snapped, since clipping makes new vertices, which are.
HomogeneousPoint snapped_position(const ScenePrimitive& primitive, std::size_t vertex,
                                  const CoverageChoice& choice, const Target& target);

class VertexAttributes {
 public:
  // Only vertices take snapped positions; the points of a clipped primitive stay.
  VertexAttributes(const ScenePrimitive& primitive, const RuleChoices& choices,
                   const Target& target);

  // One number at each vertex. If nothing of a clipped primitive is visible, the result is an
  // interpolant without extent and of arbitrary value.
  Interpolant with_values(const std::array<double, 3>& values, bool perspective) const;
  // Window depth, 0 to 1, without a polygon offset.
  Interpolant depth() const;
  Interpolant inverse_w() const;  // 1/w

  // The same, widened by the permitted errors of the operations that make them from clip
  // coordinates (GL 4.6 core, 2.3.4.1): the division by w, the scaling and addition of 13.8.1 and,
  // before these, the means of 13.7.1 at vertices made by clipping.
  Interpolant permitted_depth() const;
  Interpolant permitted_inverse_w() const;

 private:
  Interpolant coordinate() const;
  Interval permitted_w(std::size_t vertex) const;

  const ScenePrimitive* primitive_;
  std::optional<ClippedPlane> plane_;
  std::optional<CutLine> cut_;
  Interpolant geometry_;  // without values
};

}  // namespace edgecase
