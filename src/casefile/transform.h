// SPDX-License-Identifier: MIT
//
// Reads `transform`: what becomes of vertices before they are drawn.
//
// {"model": [...], "view": {...}, "projection": {...}} takes vertices in object space, and meshes,
// to clip coordinates: computed once, here, in float32, so that both sides get the very same
// numbers. {"affine": [...]} moves vertices in window coordinates, exactly where the result is a
// multiple of 2^-16. Operations of a list are applied in the order written, the first one first.
#pragma once

#include <optional>
#include <vector>

#include "casefile/affine.h"
#include "casefile/fields.h"
#include "casefile/matrices.h"

namespace edgecase {

struct Transform {
  Place place;
  std::vector<AffineStep> affine;     // of vertices in window coordinates
  std::optional<Place> affine_place;  // where the file has "affine"
  Matrix matrix = kIdentity;          // projection times view times model
  bool has_matrix = false;            // the file has one of those
};

// Adds findings for what is wrong; the result is then incomplete.
Transform read_transform(const Place& place, Findings& findings);

// {"translate": ...} and so on, one key; `read_affine` for window coordinates, two numbers where
// `read_operations` has three. Both take a list of at most kMaxOperations.
constexpr std::size_t kMaxOperations = 64;
std::vector<AffineStep> read_affine(const Place& place, Findings& findings);
Matrix read_operations(const Place& place, Findings& findings);

// {"look_at": ...} or a list of operations; {"perspective": ...}, {"frustum": ...},
// {"orthographic": ...} or {"matrix": ...}.
Matrix read_view(const Place& place, Findings& findings);
Matrix read_projection(const Place& place, Findings& findings);

}  // namespace edgecase
