// SPDX-License-Identifier: MIT
//
// Affine maps of window coordinates: x' = a x + c y + e, y' = b x + d y + f.
//
// Computed in integers, steps of 2^-48 pixels: moving, scaling by multiples of 2^-16, shearing and
// quarter turns are exact as long as the result needs no finer steps, and whether anything was
// rounded is told. The cosine of any other angle is rounded to 2^-48.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "exact/fixed.h"

namespace edgecase {

// One map. a, b, c, d have magnitude 2^10 at most, e and f 2^14.
struct AffineStep {
  std::array<std::int64_t, 4> linear{};  // a, b, c, d, in steps of 2^-48
  std::array<std::int64_t, 2> shift{};   // e, f, in steps of 2^-48 pixels
  bool exact = true;                     // false: a and the others were rounded themselves
};

constexpr int kMaxAffineFactor = 1024;  // largest magnitude of a, b, c, d
constexpr int kMaxAffineShift = 16384;  // of e and f, pixels

// x' = a x + c y + e, y' = b x + d y + f, with exact numbers.
AffineStep affine_step(const std::array<Fixed, 6>& a_to_f);

// A turn about (0, 0) by an angle in degrees, counterclockwise where y points up.
AffineStep turn_step(Fixed degrees);

struct MovedPoint {
  Point point;         // multiples of 2^-16, the nearest ones
  bool exact = false;  // nothing was rounded on the way
};

// The maps one after the other, the first one first. None where a coordinate leaves
// [-2^14, 2^14] on the way.
std::optional<MovedPoint> move_point(Point point, std::span<const AffineStep> steps);

}  // namespace edgecase
