// SPDX-License-Identifier: MIT
//
// Flat and smooth attributes, and depth: a policy's choices. The arithmetic of interpolation is in
// rules/values/interpolation.h.
#pragma once

#include <cstddef>
#include <span>

#include "model/scene.h"
#include "rules/rule.h"
#include "rules/values/interpolation.h"

namespace edgecase {

// Essay: Flat attributes
//
// Flat attributes and the provoking vertex (GL 4.6 core, flat shading in chapter 13).
//
// A flat attribute takes the value of one vertex of the primitive, the provoking vertex. That is
// the last vertex by default, and the first where the scene asks for it. Nothing is computed, so
// the value must arrive unchanged.

Rule flat_attribute_rule();
Rule provoking_vertex_rule();

enum class ProvokingChoice { as_set, first, last };
template <>
inline constexpr auto kNames<ProvokingChoice> = std::to_array<TabledAlternative<ProvokingChoice>>(
    {{ProvokingChoice::as_set, "as-set", Openness::mandated,
      "the vertex that the scene's convention names"},
     {ProvokingChoice::first, "first", Openness::illegal,
      "the first vertex, whatever the scene says"},
     {ProvokingChoice::last, "last", Openness::illegal,
      "the last vertex, whatever the scene says"}});

// The index of the provoking vertex, 0 to vertices_of(kind) - 1.
std::size_t provoking_index(const ScenePrimitive& primitive, ProvokingChoice choice);

// Essay: Interpolation
//
// Smooth attributes and depth: a policy's choices for interpolation (GL 4.6 core, 14.5.1 and
// 14.6.1). The arithmetic is in rules/values/interpolation.h.
//
// A fragment's centre and two vertices of a triangle span a smaller triangle. Its area, divided by
// the whole area, is the share of the third vertex. On a line, the centre is projected onto the
// segment. The share of the segment's end is the distance from the start to that projection,
// divided by the segment's length. Shares add up to 1. With w the vertices' clip w, the fragment
// has
//
//   depth, noperspective    sum of share * value
//   smooth                  (sum of share * value / w) / (sum of share / w)
//   gl_FragCoord.w          sum of share / w
//
// Where all w are equal, the first two agree. Exact rounds once, at the end.

Rule smooth_attribute_rule();      // attribute.smooth: along a line, by which parameter
Rule perspective_rule();           // attribute.perspective
Rule attribute_positions_rule();   // attribute.positions
Rule depth_rule();                 // fragment.depth
Rule fragment_coordinates_rule();  // fragment.coordinates: gl_FragCoord
inline constexpr int kRulingOnInterpolation = 9;  // of depths, too
inline constexpr int kRulingOnLineValues = 46;    // by the major axis, or of a wide line's column
inline constexpr int kRulingOnCoordinatePlaces = 63;  // elsewhere in the pixel

// Whether attributes are divided by w.
enum class PerspectiveChoice {
  as_set,  // smooth ones are, noperspective ones are not
  always,
  never,
  w_of_centre,  // as set, but by w at the pixel's centre, wherever the attribute is evaluated
};
template <>
inline constexpr auto kNames<PerspectiveChoice> = std::to_array<
    TabledAlternative<PerspectiveChoice>>(
    {{PerspectiveChoice::as_set, "as-set", Openness::mandated,
      "smooth attributes are divided by w, noperspective ones not"},
     {PerspectiveChoice::always, "always", Openness::illegal, "all attributes are divided by w"},
     {PerspectiveChoice::never, "never", Openness::illegal, "no attribute is divided by w"},
     {PerspectiveChoice::w_of_centre, "w-of-centre", Openness::illegal,
      "smooth attributes of multisampled targets, evaluated elsewhere in the pixel, are multiplied "
      "by w at its centre"}});

// The positions from which the weights of the vertices are computed: the exact ones, or those to
// which coverage has snapped them.
enum class AttributePositions { unsnapped, snapped };
template <>
inline constexpr auto kNames<AttributePositions> =
    std::to_array<TabledAlternative<AttributePositions>>(
        {{AttributePositions::unsnapped, "unsnapped", Openness::open,
          "from the vertices' own positions, whatever grid coverage uses"},
         {AttributePositions::snapped, "snapped", Openness::open,
          "from the positions that coverage has snapped them to"}});

template <>
inline constexpr auto kNames<LineParameter> = std::to_array<TabledAlternative<LineParameter>>(
    {{LineParameter::projection, "projection", Openness::mandated,
      "along a line by the sample's projection onto it, t = (p - a).(b - a) / |b - a|^2"},
     {LineParameter::major_axis, "major-axis", Openness::illegal,
      "along a line by the sample's coordinate on the major axis alone; Vulkan allows it, "
      "OpenGL's text does not"}});

// True if a draw's colour is divided by w under a choice. Flat colours are not interpolated at all.
bool divides_by_w(Interpolation interpolation, PerspectiveChoice choice);

}  // namespace edgecase
