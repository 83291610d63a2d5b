// SPDX-License-Identifier: MIT
//
// Viewports that hand OpenGL the very numbers of the case file.
//
// OpenGL takes clip coordinates and computes the window position itself: with centre c and size s
// of the viewport, a vertex at x is sent as (x - c) / (s / 2) and comes back as that times s / 2
// plus c, all in float32 (24 significant bits). If x, x - c and the quotient are each float32
// numbers, then nothing is rounded on the way. A power-of-two size makes the quotient as exact as
// the difference; the right centre keeps the difference short. The third coordinate needs no check:
// multiples of 2^-16 in [-1, 1], and (z + 1) / 2, have at most 18 significant bits.
//
// With a w other than 1, what is sent are the products of these quotients (and of z) with w: they
// must be float32 numbers, too. A power of two keeps them so.
//
// Vertices stay strictly inside, since a clipped vertex is a new, rounded one.
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
// keeps their coordinates exact: sizes are powers of two, the origin is at whole pixels, as near to
// (0, 0) as can be. Lines wider and points larger than a pixel get room for half their size round
// their vertices. Where exactness cannot be had, the smallest that contains all is returned and
// find_inexactness tells which vertex is to blame. None when a side would exceed kMaxViewportSize.
// Where any vertex is given as clip coordinates, whose place depends on the viewport: that of
// clip_viewport. All of it holds for vertices as they are moved by each pass, where there are
// some.
std::optional<Viewport> choose_viewport(const Target& target, const std::vector<Draw>& draws,
                                        const Supersampling& passes = {});

// By which the passes move vertices along x and along y: each distance once, in pixels. Without
// passes nothing is moved: 0.
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

// None when the coordinate is exact in every step and strictly inside. `axis`: 'x' or 'y'; w > 0.
std::optional<Inexactness> find_inexactness(Fixed coordinate, ViewportSide side, char axis,
                                            float w = 1);

// None when z * w is a float32 number. `z` lies in [-1, 1]; w > 0.
std::optional<Inexactness> find_depth_inexactness(Fixed z, float w);

// Whether n is a float32 number, scaled by any power of two: at most 24 significant bits.
bool fits_float32(std::int64_t n);

// Clip coordinates that both sides can be given: no finer than exact coverage can hold (see
// ClipPosition), and outside the clip volume only where clipping is known.

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
