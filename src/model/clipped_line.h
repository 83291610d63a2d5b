// SPDX-License-Identifier: MIT
//
// The part of a line inside the clip volume (GL 4.6 core, 13.7), or between the near and the far
// plane (OpenGL ES 3.2, 12.5): the segment between two of its
// points, which are quotients of integers in either form of vertices.
//
// Its header of rational numbers adds seconds to each compilation; include it only where needed.
#pragma once

#include <optional>

#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "model/scene.h"

namespace edgecase {

// Clip coordinates of unbounded precision.
struct RationalClip {
  Rational x, y, z, w;
};

// Clip coordinates of a vertex in either form.
RationalClip rational_clip(const Vertex& vertex, const Viewport& viewport);

// The point at the fraction `part` of the way from one to the other.
RationalClip between(const RationalClip& from, const RationalClip& to, const Rational& part);

// The fractions of the way, 0 to 1, between which a line is not clipped.
struct VisiblePart {
  Rational from = 0;
  Rational to = 1;
};
// Nothing if no point of the line, or only one, lies there. `sides`: all six planes clip, and not
// only near and far.
std::optional<VisiblePart> visible_part(const RationalClip& from, const RationalClip& to,
                                        bool sides = true);

// Whether more than one point lies between the planes, if only where it runs to infinity.
bool is_partly_inside(const RationalClip& from, const RationalClip& to, bool sides);

// The window position of a point in front of the eye; nothing if no HomogeneousPoint can hold it.
std::optional<HomogeneousPoint> window_place(const RationalClip& clip, const Viewport& viewport);

}  // namespace edgecase
