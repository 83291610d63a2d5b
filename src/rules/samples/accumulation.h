// SPDX-License-Identifier: MIT
//
// Accumulation: one colour from the passes of a supersampled scene (model/sampling.h).
//
// The colour is the weighted mean of the passes. This is our definition, since the specification
// has no passes. Renderers add in single precision, where sums of many terms are off in their last
// digits. The bound on this error is derived from the precision of each operation.
#pragma once

#include <span>
#include <string_view>

#include "exact/interval.h"
#include "model/sampling.h"
#include "rules/rule.h"

namespace edgecase {

Rule accumulation_rule();  // supersample.accumulation

enum class Accumulation {
  exact_mean,   // the double nearest to the weighted mean, a tie to the even one, never -0
  float32_sum,  // colours times weights, added in the passes' order, over the sum of weights
  clamped,      // the mean of colours that are clamped to [0, 1] first
  bytes,        // the mean of colours that are converted to 8 bits first
  unweighted,   // the mean as if all weights were 1
  sum,          // not divided
};
template <>
inline constexpr auto kNames<Accumulation> = std::to_array<TabledAlternative<Accumulation>>(
    {{Accumulation::exact_mean, "exact-mean", Openness::open, "the weighted mean, rounded once"},
     {Accumulation::float32_sum, "float32-sum", Openness::open,
      "colours times weights, added in single precision in the passes' order, over the sum of "
      "weights"},
     {Accumulation::clamped, "clamped", Openness::illegal,
      "each pass's colour is clamped to 0 to 1 before it is added"},
     {Accumulation::bytes, "bytes", Openness::illegal,
      "each pass's colour is converted to 8 bits before it is added"},
     {Accumulation::unweighted, "unweighted", Openness::illegal, "every pass counts the same"},
     {Accumulation::sum, "sum", Openness::illegal, "the sum is not divided"}});

// One component of a pixel; `shown` has a value for each pass. If one of them is not finite, the
// result is that of IEEE 754 arithmetic.
double accumulated(std::span<const double> shown, const Supersampling& passes, Accumulation choice);

// The numbers that ruling 36 permits for `choice`, with float32_sum permitting the same as
// exact_mean: those no farther from the exact one than
//
//   g S + 2 m (W + 2 n + D) / D,  g = (n + 5) u / (1 - (n + 5) u)
//
// with n passes, S the mean of the absolute values that they show, W the sum of weights, D the
// divisor (W, for a sum 1), u = 2^-23 and m = 2^-126.
//
// Each operation is off by at most u of its result, one unit in the last place (GLSL 4.60, 4.7.1;
// blending is as precise as float32, GL 4.6 core, 17.3.6). A term goes through one multiplication,
// at most n additions, and a division of at most 2.5 units, here 3, by a number that was rounded
// once: n + 5 factors 1 + d with |d| <= u, whose product is off by at most g. Numbers below m may
// be flushed to 0, each being off by at most m: the colours, times weights W m, and 2 n products
// and sums, all over D, and the quotient; these errors may grow by 1 + g, which is below 2.
// Everything if a colour is not finite, or the sum may overflow: the specification says nothing of
// such numbers.
Interval accumulation_permitted(std::span<const double> shown, const Supersampling& passes,
                                Accumulation choice);

}  // namespace edgecase
