// SPDX-License-Identifier: MIT
//
// The part of a line inside the clip volume (GL 4.6 core, 13.7): the segment between two of its
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

// The fractions of the way, 0 to 1, between which a line lies in the clip volume.
struct VisiblePart {
  Rational from = 0;
  Rational to = 1;
};
// Nothing if no point of the line, or only one, lies there.
std::optional<VisiblePart> visible_part(const RationalClip& from, const RationalClip& to);

// The window position of a point of the clip volume; nothing if no HomogeneousPoint can hold it.
std::optional<HomogeneousPoint> window_place(const RationalClip& clip, const Viewport& viewport);

}  // namespace edgecase
