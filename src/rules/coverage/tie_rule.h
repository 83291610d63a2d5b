// SPDX-License-Identifier: MIT
//
// Ties: what happens when a sample lies exactly on a boundary.
//
// The coverage rules test whether functions of the sample are positive: an edge function of a
// triangle, a side of a point's square, a side of a line's diamond. A function can be exactly zero.
// A perturbed rule then moves the sample by (+-e, +-e^2) or (+-e^2, +-e), for every e below some
// bound, and tests again: the first word of the rule's name is the direction that dominates.
// `left-bottom` moves the sample by (+e, +e^2), y up: a sample on a left edge (interior to its
// right) moves inside, so left edges are owned and, of horizontal edges, bottom ones. There are
// exactly eight such orders, and each gives a sample on an edge shared by two triangles to exactly
// one of them.
//
// OpenGL's own perturbation of line endpoints, by -(e, e^2) (GL 4.6 core, 14.5.1), is `left-bottom`
// too: moving both endpoints one way equals moving the sample the other way.
//
// `open` and `closed` decide ties without moving anything: boundaries never count, or always do.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exact/fixed.h"
#include "rules/rule.h"

namespace edgecase {

struct TieRule {
  enum class Kind { perturbed, open, closed };

  std::string_view name;
  Kind kind = Kind::perturbed;
  // Direction of the sample's move: e * (first_x, first_y) + e^2 * (second_x, second_y).
  int first_x = 0, first_y = 0, second_x = 0, second_y = 0;

  // True if a function is positive at the sample. `value` is the function there, (gradient_x,
  // gradient_y) its growth as the sample moves right and up; the function is linear. Magnitudes up
  // to 2^120.
  constexpr bool positive(Int128 value, Int128 gradient_x, Int128 gradient_y) const {
    if (value != 0) return value > 0;
    if (kind != Kind::perturbed) return kind == Kind::closed;
    const Int128 first = gradient_x * first_x + gradient_y * first_y;
    if (first != 0) return first > 0;
    return gradient_x * second_x + gradient_y * second_y > 0;
  }

  friend constexpr bool operator==(const TieRule&, const TieRule&) = default;
};

// The rule of a target seen upside down, in upright coordinates; it keeps its name.
constexpr TieRule turned_over(TieRule ties) {
  ties.first_y = -ties.first_y;
  ties.second_y = -ties.second_y;
  return ties;
}

// The eight perturbed rules, then open and closed.
std::span<const TieRule> all_tie_rules();

// Null if there is none of that name.
const TieRule* find_tie_rule(std::string_view name);
const TieRule& open_ties();  // "open" and "closed" of the catalogue
const TieRule& closed_ties();

// Catalogue entries for a rule whose alternatives are these tie rules.
std::vector<Alternative> tie_alternatives(std::span<const TieRule> rules, Openness perturbed,
                                          Openness open_and_closed);

// The boundary of a line's diamond. OpenGL avoids the question: it moves the endpoints by an
// infinitesimal, so boundaries are never hit (a perturbed tie rule). Direct3D and some courses
// answer it: some of the diamond's four edges (without their ends) and four corners count as
// inside, in Direct3D different ones for x-major and for y-major lines.
//
// Parts of the boundary, y up, as bits of a set.
enum DiamondPart : unsigned {
  kLeftCorner = 1u << 0,
  kRightCorner = 1u << 1,
  kBottomCorner = 1u << 2,
  kTopCorner = 1u << 3,
  kLowerLeftEdge = 1u << 4,
  kLowerRightEdge = 1u << 5,
  kUpperLeftEdge = 1u << 6,
  kUpperRightEdge = 1u << 7,
};

struct DiamondBoundary {
  std::string_view name;
  // If set: ties are decided by moving the diamond, or by all-open or all-closed boundaries.
  const TieRule* ties = nullptr;
  // Otherwise: the parts that count as inside, for x-major and for y-major segments.
  unsigned x_major_parts = 0;
  unsigned y_major_parts = 0;
};

// The ten tie rules, then "direct3d" and "scotty3d".
std::span<const DiamondBoundary> all_diamond_boundaries();

// Null if there is none of that name.
const DiamondBoundary* find_diamond_boundary(std::string_view name);

}  // namespace edgecase
