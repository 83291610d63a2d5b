// SPDX-License-Identifier: MIT
//
// Resolving: one 8-bit value from a pixel's samples (GL 4.6 core, 18.3.1).
//
// glBlitFramebuffer can copy from a multisampled framebuffer to a single-sampled one. It then makes
// one value of each pixel's samples. The specification does not say how. Implementations take the
// mean and round it in different ways.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "rules/rule.h"

namespace edgecase {

Rule resolve_rule();  // sample.resolve

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

}  // namespace edgecase
