// SPDX-License-Identifier: MIT
//
// From several samples or passes to one colour: resolving and supersampling.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "exact/interval.h"
#include "model/sampling.h"
#include "rules/rule.h"

namespace edgecase {

// Essay: Resolving samples
//
// Resolving: one 8-bit value from a pixel's samples (GL 4.6 core, 18.3.1).
//
// glBlitFramebuffer can copy from a multisampled framebuffer to a single-sampled one. It then makes
// one value of each pixel's samples. The specification does not say how. Implementations take the
// mean and round it in different ways.

Rule resolve_rule();  // sample.resolve
inline constexpr int kRulingBeyondSamples = 51;

enum class ResolveMethod {
  nearest_even,      // the mean, rounded to nearest, a tie to the even value
  half_up,           // a tie to the larger value
  truncated,         // the largest value that is not above the mean
  half_up_by_pairs,  // means of pairs, then of their means, each rounded half up
  float32_sum,       // the sum of value/255 in single precision, in the order of the samples
  first_sample,
};
template <>
inline constexpr auto kNames<ResolveMethod> = std::to_array<TabledAlternative<ResolveMethod>>(
    {{ResolveMethod::nearest_even, "nearest-even", Openness::open,
      "the mean of the samples, rounded to nearest, a tie to the even value"},
     {ResolveMethod::half_up, "half-up", Openness::open,
      "the mean, rounded to nearest, a tie to the larger value"},
     {ResolveMethod::truncated, "truncated", Openness::open,
      "the largest value that is not above the mean"},
     {ResolveMethod::half_up_by_pairs, "half-up-by-pairs", Openness::open,
      "the means of neighbouring samples, then the means of these in turn, each rounded half up"},
     {ResolveMethod::float32_sum, "float32-sum", Openness::open,
      "the mean of values/255 in single precision, summed in the samples' order, then rounded to "
      "nearest: a tie goes either way"},
     {ResolveMethod::first_sample, "first-sample", Openness::open, "sample 0 alone"}});

// The resolved value of 1 to kMaxSamples samples.
std::uint8_t resolved(std::span<const std::uint8_t> samples, ResolveMethod method);

// The values that ruling 31 accepts, both inclusive: from the least to the greatest sample, and
// kResolveMargin codes beyond.
struct ResolvedRange {
  int low = 0;
  int high = 0;
  bool contains(int value) const { return low <= value && value <= high; }
};
inline constexpr int kResolveMargin = 12;
ResolvedRange resolve_permitted(std::span<const std::uint8_t> samples);

// Essay: Supersampling
//
// Accumulation: one colour from the passes of a supersampled scene (model/sampling.h).
//
// The colour is the weighted mean of the passes. This is our definition, since the specification
// has no passes. Renderers add in single precision, where sums of many terms are off in their last
// digits. The bound on this error is derived from the precision of each operation.

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
