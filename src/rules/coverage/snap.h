// SPDX-License-Identifier: MIT
//
// Sub-pixel snapping: vertices are rounded to a grid of 2^-b pixels before anything else is
// decided.
//
// OpenGL's ideal rasterization has no grid. Implementations have one. GL_SUBPIXEL_BITS reports its
// b, which is at least 4 (GL 4.6 core, implementation-dependent values). Policy `opengl` snaps
// nothing, and a renderer that snaps is explained by the alternative that it follows. Snapping
// precedes edge setup: a triangle may become degenerate, and two triangles may come to overlap.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "rules/rule.h"

namespace edgecase {

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
