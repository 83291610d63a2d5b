// SPDX-License-Identifier: MIT
//
// Points (GL 4.6 core, 14.4): which pixels a point covers.
//
// A point produces a fragment for each pixel whose centre lies inside a square around its vertex.
// The square is as wide as the point's size. A point of size 1 produces exactly one fragment,
// unless a centre lies on the square's boundary. The specification does not say who owns the
// boundary. The older text of OpenGL does, for points without antialiasing: it draws the pixel at
// (floor x, floor y). That is tie rule `right-top`. The square owns centres on its right and top
// sides, and not those on its left and bottom sides.
#pragma once

#include <span>

#include "exact/homogeneous.h"
#include "model/scene.h"
#include "rules/coverage/tie_rule.h"
#include "rules/rule.h"

namespace edgecase {

Rule point_ownership_rule();
Rule point_offset_rule();
Rule point_clip_rule();

// The offset of a point's square. Mesa's drivers without points of their own draw two triangles an
// eighth of a pixel off.
enum class PointOffset { none, right_down };
template <>
inline constexpr auto kNames<PointOffset> = std::to_array<TabledAlternative<PointOffset>>(
    {{PointOffset::none, "none", Openness::mandated, "the vertex is the centre of the square"},
     {PointOffset::right_down, "right-down", Openness::illegal,
      "the square lies 1/8 pixel to the right and below"}});
// What clips a point: its vertex alone, against the clip volume with its border.
enum class PointClip { as_set, border_dropped, cut_at_viewport, of_other_api };
template <>
inline constexpr auto kNames<PointClip> = std::to_array<TabledAlternative<PointClip>>(
    {{PointClip::as_set, "as-set", Openness::mandated,
      "a point is drawn whole if its vertex lies in the clip volume or on its border"},
     {PointClip::border_dropped, "border-dropped", Openness::illegal,
      "a vertex on the border of the clip volume counts as outside"},
     {PointClip::cut_at_viewport, "cut-at-viewport", Openness::illegal,
      "what of the square lies beyond the viewport is not drawn"},
     {PointClip::of_other_api, "of-other-api", Openness::open,
      "in OpenGL a vertex beyond the viewport's sides clips nothing, as in OpenGL ES; in OpenGL ES "
      "it clips the point, as OpenGL permits"}});
// True if the vertex of a point lies on the border of the clip volume.
bool is_on_border(const ScenePrimitive& point);

// The vertex moved by an offset.
Point moved(Point vertex, PointOffset offset);

// The tie rules that differ for points: the four with left or right first, open, closed. A square's
// sides run along the axes, so it does not matter which of two directions dominates.
std::span<const TieRule> point_tie_rules();

// A point of a size above 0 and at most 64 pixels.
struct SizedPoint {
  Point vertex;
  Fixed size = Fixed::from_integer(1);
};

// True if the point's square contains the sample, or the centre of pixel (x, y).
bool point_covers(const SizedPoint& point, Point sample, const TieRule& ties);
inline bool point_covers(const SizedPoint& point, int x, int y, const TieRule& ties) {
  return point_covers(point, pixel_centre(x, y), ties);
}

// The reason, in a sentence with numbers.
Explanation explain_point(const SizedPoint& point, Point sample, const TieRule& ties);
inline Explanation explain_point(const SizedPoint& point, int x, int y, const TieRule& ties) {
  return explain_point(point, pixel_centre(x, y), ties);
}

// Whether the specification's latitude permits the sample to be covered, and to be uncovered. The
// vertex may move by less than `reach` in x and y, and boundaries are open.
bool point_possibly_covered(const SizedPoint& point, Point sample, Fixed reach);
bool point_possibly_uncovered(const SizedPoint& point, Point sample, Fixed reach);
inline bool point_possibly_covered(const SizedPoint& point, int x, int y, Fixed reach) {
  return point_possibly_covered(point, pixel_centre(x, y), reach);
}
inline bool point_possibly_uncovered(const SizedPoint& point, int x, int y, Fixed reach) {
  return point_possibly_uncovered(point, pixel_centre(x, y), reach);
}

// A point whose vertex is the quotient (x/w, y/w), of a size above 0 and at most 64 pixels. The w
// is at most 2^35, the result of an offset. The rule is the same; every distance is multiplied by
// w, so that all of them are integers and a centre on the boundary of the square is recognized
// exactly.
struct HomogeneousSizedPoint {
  HomogeneousPoint vertex;
  Fixed size;
};

// The vertex moved by an offset.
HomogeneousPoint moved(const HomogeneousPoint& vertex, PointOffset offset);

// True if the point's square contains the sample, or the centre of pixel (x, y).
bool point_covers(const HomogeneousSizedPoint& point, Point sample, const TieRule& ties);
inline bool point_covers(const HomogeneousSizedPoint& point, int x, int y, const TieRule& ties) {
  return point_covers(point, pixel_centre(x, y), ties);
}

}  // namespace edgecase
