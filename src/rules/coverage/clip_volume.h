// SPDX-License-Identifier: MIT
//
// Primitive clipping (GL 4.6 core, 13.7): only the part of a primitive inside the clip volume is
// rasterized, -w <= x, y, z <= w.
//
// Clipping does not require that a triangle is cut. Let v_i = (x_i, y_i, w_i) be its vertices in
// the window. A sample s = (x, y, 1) is the sum of b_i v_i. The triangle covers the sample where
// all b_i are positive, whatever the signs of the w_i (Olano and Greer, "Triangle Scan Conversion
// using 2D Homogeneous Coordinates", 1997). The sample lies between the near and the far plane
// where the sum of b_i z_i lies between -1 and 1. The other four planes are the viewport's sides.
// This method makes no new vertices and rounds nothing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "model/scene.h"
#include "rules/coverage/tie_rule.h"
#include "rules/rule.h"

namespace edgecase {

Rule clip_volume_rule();  // clip.volume
Rule line_clip_rule();    // line.clip

// The rulings on depths and values of a polygon that are not on its triangle's plane.
inline constexpr int kRulingOnPolygonDepth = 44;
inline constexpr int kRulingOnPolygonValues = 66;
// The ruling on fragments of points and lines that are left out beyond the viewport's sides.
inline constexpr int kRulingOnViewport = 54;
// The ruling on points and lines of OpenGL ES that lack fragments beside the viewport's sides.
inline constexpr int kRulingOnSides = 68;

enum class ClipMethod {
  homogeneous,    // sample by sample, as above
  polygon,        // as a polygon, cut at all six planes; new vertices are snapped like others
  guard_band,     // the same, cut at near and far, and only 8192 pixels away in x and y
  doubled_sides,  // the same, cut at near, far and the sides of a volume twice as wide and high
  discarded,      // a primitive that reaches out of the volume is dropped whole
  depth_ignored,  // sample by sample, but for near and far
  sides_ignored,  // the same, but for the viewport's sides
};
template <>
inline constexpr auto kNames<ClipMethod> = std::to_array<TabledAlternative<ClipMethod>>(
    {{ClipMethod::homogeneous, "homogeneous", Openness::open,
      "nothing is cut; each sample is compared with the volume"},
     {ClipMethod::polygon, "polygon", Openness::open,
      "cut at all six planes; new vertices are snapped as others are"},
     {ClipMethod::guard_band, "guard-band", Openness::open,
      "the same at near and far, and at the sides only where a vertex lies beyond 8192 pixels"},
     {ClipMethod::doubled_sides, "doubled-sides", Openness::open,
      "the same at near and far, and at the sides of a volume twice as wide and as high"},
     {ClipMethod::discarded, "discarded", Openness::illegal,
      "a triangle that is partly outside the volume is dropped"},
     {ClipMethod::depth_ignored, "depth-ignored", Openness::illegal,
      "parts nearer than near or farther than far are drawn too"},
     {ClipMethod::sides_ignored, "sides-ignored", Openness::illegal,
      "parts beyond the viewport's sides are drawn too"}});

// The planes that clip lines: all six in OpenGL, near and far alone in OpenGL ES (3.2, 12.5).
enum class LineClip { as_set, of_other_api };
template <>
inline constexpr auto kNames<LineClip> = std::to_array<TabledAlternative<LineClip>>(
    {{LineClip::as_set, "as-set", Openness::mandated,
      "the planes clip that the API says: all six in OpenGL, near and far in OpenGL ES"},
     {LineClip::of_other_api, "of-other-api", Openness::illegal,
      "in OpenGL the viewport's sides do not cut a line, as in OpenGL ES; in OpenGL ES they do, as "
      "in OpenGL"}});

// A triangle with some vertices outside the volume: positions with a w of either sign, and z over
// the same w.
struct UnclippedTriangle {
  std::array<HomogeneousPoint, 3> positions{};
  std::array<std::int64_t, 3> z{};
};

// True if the triangle covers a sample of the clip volume, with coordinates of at most 2^30 and w
// of at most 2^16. `depth`: near and far cut.
bool clipped_triangle_covers(const UnclippedTriangle& triangle, const HomogeneousPoint& sample,
                             const TieRule& ties, bool depth = true);

// The pixels within `bounds` whose sample, at position `within`, is covered; each once.
std::vector<PixelPosition> clipped_triangle_pixels(const UnclippedTriangle& triangle,
                                                   const Viewport& viewport,
                                                   const PixelBounds& bounds, const TieRule& ties,
                                                   Point within, bool depth = true);

// True if a sample lies in the viewport, including its sides.
bool is_in_viewport(const HomogeneousPoint& sample, const Viewport& viewport);

// Explains by the homogeneous method, which decides without vertices of its own. With the outline
// of the triangle's visible part.
Explanation explain_clipped_triangle(const ScenePrimitive& triangle, Point sample,
                                     const TieRule& ties);

// For a point: its vertex lies outside, so nothing of it is drawn.
Explanation explain_clipped_point(const ScenePrimitive& point, Point sample);

// The outline of a clipped triangle's visible part through its viewport; nothing for a point.
Figure figure_of_seen(const ScenePrimitive& primitive);

}  // namespace edgecase
