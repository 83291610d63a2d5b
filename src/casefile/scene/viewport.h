// SPDX-License-Identifier: MIT
//
// Viewports with which OpenGL receives exactly the numbers of the case file.
//
// OpenGL takes clip coordinates and computes the window position itself: with centre c and size s
// of the viewport, a vertex at x is sent as (x - c) / (s / 2) and comes back as that times s / 2
// plus c, all in float32 (24 significant bits). If x, x - c and the quotient are each float32
// numbers, nothing is rounded on the way. A power-of-two size makes the quotient as exact as the
// difference; the right centre keeps the difference short. The third coordinate needs no check:
// multiples of 2^-16 in [-1, 1], and (z + 1) / 2, have at most 18 significant bits.
//
// With a w other than 1, the products of these quotients (and of z) with w are sent and must be
// float32 numbers, too. A power of two keeps them so.
//
// Vertices stay strictly inside, since clipping would replace them by new, rounded ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "model/scene.h"

namespace edgecase {

constexpr int kMaxViewportSize = 16384;

// The smallest viewport that contains the target's rectangle, has all vertices strictly inside and
// keeps their coordinates exact. Sizes are powers of two, and the origin is at whole pixels, as
// near to (0, 0) as possible. Lines wider and points larger than a pixel get a margin of half their
// size. If exactness is impossible, the smallest that contains everything is returned, and
// find_inexactness names the vertex at fault. Nothing if a side would exceed kMaxViewportSize. If
// any vertex is given in clip coordinates, whose position depends on the viewport, the result is
// clip_viewport. All of this applies to vertices as moved by each pass, if there are passes.
std::optional<Viewport> choose_viewport(const Target& target, const std::vector<Draw>& draws,
                                        const Supersampling& passes = {});

// The distances by which passes move vertices along x and y, in pixels, without duplicates; just 0
// without passes.
struct Shifts {
  std::vector<Fixed> x;
  std::vector<Fixed> y;
};
Shifts shifts_of(const Supersampling& passes);

// The smallest viewport at (0, 0) that contains the target and has powers of two as sizes.
Viewport clip_viewport(const Target& target);

bool has_clip_vertices(const std::vector<Draw>& draws);

// One side of a viewport, in whole pixels: [origin, origin + size].
struct ViewportSide {
  int origin = 0;
  int size = 0;
};

// Why a coordinate along this side would not reach OpenGL unrounded and unclipped.
struct Inexactness {
  std::string message;
  std::string remedy;
};

// Nothing if the coordinate is exact in every step and strictly inside. `axis`: 'x' or 'y'; w > 0.
std::optional<Inexactness> find_inexactness(Fixed coordinate, ViewportSide side, char axis,
                                            float w = 1);

// Nothing if z * w is a float32 number. `z` lies in [-1, 1]; w > 0.
std::optional<Inexactness> find_depth_inexactness(Fixed z, float w);

// Whether n is a float32 number, scaled by any power of two: at most 24 significant bits.
bool fits_float32(std::int64_t n);

// Clip coordinates that both sides can receive: no finer than exact coverage supports (see
// ClipPosition), and outside the clip volume only where clipping is supported.

// The range of w in either form of vertex: 2^-20 to 2^20. Outside the clip volume, the range of the
// largest of |x|, |y|, |z| and |w|.
constexpr float kMinW = 1.0F / 1048576;
constexpr float kMaxW = 1048576;

// Rounds all four to the nearest multiples of 2^(e-30), with 2^e the power of two at or below their
// largest magnitude; ties to even, -0 becomes 0. For coordinates without a fault.
ClipPosition round_to_grid(const ClipPosition& clip);

// "(0.5, -1, 0, 2)", shortest decimals.
std::string text_of(const ClipPosition& clip);

// Why the coordinates cannot be drawn anywhere: out of range, or not numbers. The fault's message
// starts with `subject`.
std::optional<Inexactness> find_clip_fault(const ClipPosition& clip, const std::string& subject);

// Why coordinates without such a fault lie outside the clip volume; nothing if they do not.
std::optional<Inexactness> find_volume_fault(const ClipPosition& clip, const std::string& subject);

// Whether exact coverage supports vertices outside the clip volume with this viewport.
bool fits_clipping(const Viewport& viewport);

// Fills in `position`, `z` and `w` of a vertex with clip coordinates: the nearest multiples of
// 2^-16 or, outside the clip volume, 0 except for w.
void place_clip_vertex(const Viewport& viewport, Vertex& vertex);

}  // namespace edgecase
