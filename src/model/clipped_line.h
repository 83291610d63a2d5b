// SPDX-License-Identifier: MIT
//
// What is left of a line in the clip volume (GL 4.6 core, 13.7): the segment between two points of
// it, which are quotients of integers however its vertices are given.
//
// The header of rational numbers costs every user seconds: include this one where it is needed.
#pragma once

#include <optional>

#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "model/scene.h"

namespace edgecase {

// Clip coordinates without a bound on their digits.
struct RationalClip {
  Rational x, y, z, w;
};

// Of a vertex given either way.
RationalClip rational_clip(const Vertex& vertex, const Viewport& viewport);

// The point at a part of the way from one to the other.
RationalClip between(const RationalClip& from, const RationalClip& to, const Rational& part);

// The parts of the way, 0 to 1, between which a line lies in the clip volume.
struct VisiblePart {
  Rational from = 0;
  Rational to = 1;
};
// None where no point of it, or a single one, lies there.
std::optional<VisiblePart> visible_part(const RationalClip& from, const RationalClip& to);

// Where a point of the clip volume lies in the window; none where no HomogeneousPoint holds it.
std::optional<HomogeneousPoint> window_place(const RationalClip& clip, const Viewport& viewport);

// Does one of the line's vertices lie outside the clip volume?
bool leaves_clip_volume(const Vertex& from, const Vertex& to);

}  // namespace edgecase
