// SPDX-License-Identifier: MIT
//
// Clip coordinates that both sides can be given: inside the clip volume, since clipped vertices are
// new ones, and no finer than exact coverage can hold (see ClipPosition).
#pragma once

#include <optional>
#include <string>

#include "casefile/viewport.h"
#include "model/scene.h"

namespace edgecase {

// The range of w, in either way to give a vertex: 2^-20 to 2^20.
constexpr float kMinW = 1.0F / 1048576;
constexpr float kMaxW = 1048576;

// x, y and z to the nearest multiples of 2^(e-30), with 2^e the power of two at or below w: ties to
// the even multiple. -0 becomes 0. w must lie in kMinW to kMaxW, and x, y, z within w.
ClipPosition round_to_grid(const ClipPosition& clip);

// "(0.5, -1, 0, 2)", shortest decimals.
std::string words_of(const ClipPosition& clip);

// Why the coordinates cannot be drawn yet: beyond w, w out of range, no numbers. None when
// |x|, |y| and |z| are all less than w. The fault's message starts with `subject`.
std::optional<Inexactness> find_clip_fault(const ClipPosition& clip, const std::string& subject);

// Fills in `position`, `z` and `w` of a vertex that has clip coordinates: the nearest multiples of
// 2^-16.
void place_clip_vertex(const Viewport& viewport, Vertex& vertex);

}  // namespace edgecase
