// SPDX-License-Identifier: MIT
//
// Rules for every primitive in the window: the position of its origin, the order in which a
// rasterizer counts its rows, the grid to which vertices are rounded, and the number of fragments
// per pixel.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "rules/rule.h"

namespace edgecase {

// Essay: The window's origin
//
// The window's origin is its lower left corner, and y runs upward.
//
// The specification says so in three places. The viewport is given by its lower left corner (GL 4.6
// core, 13.8.1). A fragment is located by the lower left corner of its grid square (14,
// introduction). Pixels are read back from the lowest row upward (18.2.2).
//
// Most image formats and most windowing systems store the top row first. A rasterizer that was
// written for them may forget to flip its picture, or flip it twice. Such a picture has a single
// fault: its rows stand in reverse order. Reporting every sample as one on the wrong side of an
// edge would hide that fault.
//
// The direction of rows while ties are decided is a separate question, which is open: see the order
// of rows.

// The rule's id, and the cause of disagreements that it explains.
inline constexpr RuleId kWindowOrigin = RuleId::window_origin;
inline constexpr int kRulingOnOrigin = 43;

Rule window_origin_rule();

// Essay: The order of rows
//
// Row order: the direction in which a rasterizer counts the rows of its target.
//
// Window coordinates have y up. The first row of a window surface in memory is the top one. A
// rasterizer that works in the order of memory therefore sees window surfaces upside down. Its ties
// and its rounding are upside down too. What it rounds up is rounded down in window coordinates.
// The edges that it takes for top edges are bottom edges.

enum class RowOrder { bottom_up, top_down };
template <>
inline constexpr auto kNames<RowOrder> = std::to_array<TabledAlternative<RowOrder>>(
    {{RowOrder::bottom_up, "bottom-up", Openness::open, "ties and rounding see y up"},
     {RowOrder::top_down, "top-down", Openness::open,
      "the target is seen upside down: ties, rounding and offsets see y down"}});

// The catalogue entry; `id` is "point.row-order", "line.row-order" or "triangle.row-order".
Rule row_order_rule(RuleId id);

// A point and a rectangle of pixels upside down in a target of `height` rows.
Point turned_over(Point point, int height);
HomogeneousPoint turned_over(const HomogeneousPoint& point, int height);
PixelBounds turned_over(const PixelBounds& bounds, int height);

// Essay: One fragment a pixel
//
// A primitive of width or size 1 produces at most one fragment per pixel.
//
// The rules for points, lines and triangles (GL 4.6 core, 14.4 to 14.6) define the set of a
// primitive's fragments. A set holds each fragment once. A fragment that is produced twice is
// blended twice.

Rule fragment_once_rule();

// Essay: A scene and its image
//
// Most rules leave an implementation some room, and say nothing of how it uses that. Invariance
// says that it must use it in one way (GL 4.6 core, 14.2 and A.3): a primitive that is moved by
// whole pixels has the same fragments, as far away; what colours are written, and what lies in the
// buffers, decides nothing about fragments; and the same commands draw the same twice. No exact
// drawing is needed to find a fault of that kind, and nothing is tolerated: two drawings of one
// renderer are held against each other. Whoever tests edges in float32 breaks it, as the numbers of
// a moved primitive are rounded elsewhere.

Rule fragment_invariant_rule();
inline constexpr int kRulingOnImages = 67;
inline constexpr int kRulingOnSuggestedImages = 70;

// Essay: The sub-pixel grid
//
// Sub-pixel snapping: vertices are rounded to a grid of 2^-b pixels before anything else is
// decided.
//
// OpenGL's ideal rasterization has no grid. Implementations have one. GL_SUBPIXEL_BITS reports its
// b, which is at least 4 (GL 4.6 core, implementation-dependent values). Policy `opengl` snaps
// nothing, and a renderer that snaps is explained by the alternative that it follows. Snapping
// precedes edge setup: a triangle may become degenerate, and two triangles may come to overlap.

// The distance between lines of a grid of `bits` bits, 0 to 16: 2^-bits pixels.
constexpr Fixed grid_step(int bits) {
  return Fixed::from_raw(Fixed::kOne >> bits);
}

struct Snap {
  enum class Rounding {
    half_even,  // to the nearest grid line, a tie to the even one
    half_up,    // to the nearest grid line, a tie to the right or up
    truncate,   // to the grid line at or below: low bits dropped
  };

  int bits = Fixed::kFractionBits;  // 4 to 12; kFractionBits: no snapping
  Rounding rounding = Rounding::half_even;

  constexpr bool is_none() const { return bits == Fixed::kFractionBits; }
  Fixed operator()(Fixed value) const;
  Point operator()(Point point) const { return {(*this)(point.x), (*this)(point.y)}; }
  // Rounds the quotient itself, once. Without snapping: to the nearest multiple of 2^-16, a tie to
  // the right or up.
  Point operator()(const HomogeneousPoint& point) const;
  friend constexpr bool operator==(Snap, Snap) = default;
};
template <>
inline constexpr auto kNames<Snap::Rounding> =
    std::to_array<Named<Snap::Rounding>>({{Snap::Rounding::half_even, "half-even"},
                                          {Snap::Rounding::half_up, "half-up"},
                                          {Snap::Rounding::truncate, "truncate"}});

// "none", "8-half-even", "4-truncate", …
std::string name_of(Snap snap);

// `none`, then 12 down to 4 bits in each rounding: if several explain something equally well, the
// one that moves vertices least comes first.
std::span<const Snap> all_snaps();

// Null if there is none of that name.
const Snap* find_snap(std::string_view name);

// The catalogue entry; `id` is "subpixel.snap" or the snap of one primitive type.
Rule snap_rule(RuleId id);

}  // namespace edgecase
