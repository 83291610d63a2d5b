// SPDX-License-Identifier: MIT
//
// Polygon offset (GL 4.6 core, 14.6.5): all fragments of a triangle get the depth
//
//   z + factor m + units r,   m = length of z's gradient in the window, per pixel
//
// clamped to 0 to 1. The larger partial derivative may take the place of m. r is the smallest
// difference of depths that is sure to remain in the buffer. For a fixed-point buffer, r is a
// constant of the implementation, and the section gives no upper bound for it. For a floating-point
// buffer, r is 2^(e - 23), where e is the exponent of the triangle's largest depth.
#pragma once

#include <span>
#include <string_view>

#include "exact/interval.h"
#include "model/scene.h"
#include "rules/rule.h"
#include "rules/values/interpolation.h"

namespace edgecase {

Rule offset_slope_rule();     // offset.slope
Rule offset_unit_rule();      // offset.unit: fixed-point buffers
Rule offset_exponent_rule();  // offset.exponent: floating-point buffers
inline constexpr int kRulingOnUnclampedDepth = 45;
inline constexpr int kRulingOnOneUnit = 64;

enum class OffsetSlope { length, largest_partial, sum_of_partials, ignored };
template <>
inline constexpr auto kNames<OffsetSlope> = std::to_array<TabledAlternative<OffsetSlope>>(
    {{OffsetSlope::length, "length", Openness::open,
      "the length of the gradient, sqrt((dz/dx)^2 + (dz/dy)^2)"},
     {OffsetSlope::largest_partial, "largest-partial", Openness::open,
      "the larger one of |dz/dx| and |dz/dy|"},
     {OffsetSlope::sum_of_partials, "sum-of-partials", Openness::illegal, "|dz/dx| + |dz/dy|"},
     {OffsetSlope::ignored, "ignored", Openness::illegal, "0: the factor does nothing"}});

// r for n bits.
enum class OffsetUnit {
  step,        // 1/(2^n - 1), the distance of neighbouring values
  power,       // 2^-n
  two_steps,   // 2/(2^n - 1)
  four_steps,  // 4/(2^n - 1)
  half_step,   // 1/(2^n - 1)/2
  of_24_bits,  // 2^-24 for every n
  ignored,
};
template <>
inline constexpr auto kNames<OffsetUnit> = std::to_array<TabledAlternative<OffsetUnit>>(
    {{OffsetUnit::step, "step", Openness::open,
      "1/(2^n - 1), the difference of neighbouring values of n bits"},
     {OffsetUnit::power, "power", Openness::open, "2^-n"},
     {OffsetUnit::two_steps, "two-steps", Openness::open, "2/(2^n - 1)"},
     {OffsetUnit::four_steps, "four-steps", Openness::open, "4/(2^n - 1)"},
     {OffsetUnit::half_step, "half-step", Openness::illegal,
      "half of 1/(2^n - 1), a difference that the buffer does not keep"},
     {OffsetUnit::of_24_bits, "of-24-bits", Openness::illegal,
      "2^-24 whatever n is, a difference that a buffer of 16 bits does not keep"},
     {OffsetUnit::ignored, "ignored", Openness::illegal, "0: the units do nothing"}});

enum class OffsetExponent {
  largest_depth,  // of the largest depth among the vertices
  doubled,        // twice as much
  halved,         // half as much
  one,            // of 1: r is 2^-23
  as_fixed,       // r as in a fixed-point buffer of 24 bits
};
template <>
inline constexpr auto kNames<OffsetExponent> = std::to_array<TabledAlternative<OffsetExponent>>(
    {{OffsetExponent::largest_depth, "largest-depth", Openness::mandated,
      "2^(e - 23), with e the exponent of the largest depth among the vertices"},
     {OffsetExponent::doubled, "doubled", Openness::illegal, "2^(e - 22)"},
     {OffsetExponent::halved, "halved", Openness::illegal, "2^(e - 24)"},
     {OffsetExponent::one, "one", Openness::illegal, "2^-23, whatever the depths are"},
     {OffsetExponent::as_fixed, "as-fixed", Openness::illegal,
      "the unit of a fixed-point buffer of 24 bits"}});

struct OffsetChoice {
  OffsetSlope slope = OffsetSlope::length;
  OffsetUnit unit = OffsetUnit::step;
  OffsetExponent exponent = OffsetExponent::largest_depth;
  friend bool operator==(const OffsetChoice&, const OffsetChoice&) = default;
};

// The offset of a triangle's depths; `depth` is before the offset. 0 for a triangle without area.
Interval offset_exact(const PolygonOffset& offset, const Interpolant& depth, DepthFormat format,
                      const OffsetChoice& choice);

// The permitted r of a fixed-point buffer: from 2^-n, just less than one step, on. Depths that are
// closer to each other become one value. Depths of 0 and 1 always differ, so r is at most 1.
Interval permitted_fixed_unit(DepthFormat format);

// The permitted offset: m from the largest partial derivative to the length, r of a fixed-point
// buffer any of `fixed_unit`; `reach` as in interpolate_permitted. Everything if the area may
// vanish, unless the factor is 0.
Interval offset_permitted(const PolygonOffset& offset, const Interpolant& depth, DepthFormat format,
                          double reach, Interval fixed_unit);

}  // namespace edgecase
