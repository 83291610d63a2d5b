// SPDX-License-Identifier: MIT
//
// Clip coordinates that both sides can be given: no finer than exact coverage can hold (see
// ClipPosition), and outside the clip volume only where clipping is known.
#pragma once

#include <optional>
#include <string>

#include "casefile/viewport.h"
#include "model/scene.h"

namespace edgecase {

// The range of w, in either way to give a vertex: 2^-20 to 2^20. Outside the clip volume, the range
// of the largest of |x|, |y|, |z| and |w|.
constexpr float kMinW = 1.0F / 1048576;
constexpr float kMaxW = 1048576;

// All four to the nearest multiples of 2^(e-30), with 2^e the power of two at or below the largest
// magnitude among them: ties to the even multiple. -0 becomes 0. For coordinates without a fault.
ClipPosition round_to_grid(const ClipPosition& clip);

// "(0.5, -1, 0, 2)", shortest decimals.
std::string words_of(const ClipPosition& clip);

// Why the coordinates cannot be drawn, wherever they lie: out of range, or no numbers. The fault's
// message starts with `subject`.
std::optional<Inexactness> find_clip_fault(const ClipPosition& clip, const std::string& subject);

// Why coordinates without such a fault lie outside the clip volume; none where they do not.
std::optional<Inexactness> find_volume_fault(const ClipPosition& clip, const std::string& subject);

// Can exact coverage hold vertices outside the clip volume that are seen through the viewport?
bool fits_clipping(const Viewport& viewport);

// Fills in `position`, `z` and `w` of a vertex that has clip coordinates: the nearest multiples of
// 2^-16, and outside the clip volume 0 but for w.
void place_clip_vertex(const Viewport& viewport, Vertex& vertex);

}  // namespace edgecase
