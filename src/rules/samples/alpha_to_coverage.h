// SPDX-License-Identifier: MIT
//
// Alpha to coverage (GL 4.6 core, 17.3.1).
//
// GL_SAMPLE_ALPHA_TO_COVERAGE turns the alpha that the shader writes into a mask. The mask is ANDed
// with the fragment's coverage. The number of its ones is proportional to alpha: all of them for 1,
// none for 0. Everything else about the mask is open, and it may differ from pixel to pixel. Every
// implementation that we know sets bits from sample 0 upward as alpha passes thresholds.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "exact/interval.h"
#include "rules/rule.h"

namespace edgecase {

Rule alpha_to_coverage_rule();  // sample.alpha-to-coverage

// Sample s of n is kept if alpha is
enum class AlphaToCoverage {
  proportional,              // at least (s + 1/2) / n: as many as alpha n, rounded
  above_quotient,            // above s / n
  above_quotient_of_others,  // the same; if the shader runs for each sample: all alphas of the
                             // pixel except the sample's own
  spread,                    // at least (s + 1) / (n + 1)
  ignored,                   // anything: alpha is ignored
};
template <>
inline constexpr auto kNames<AlphaToCoverage> = std::to_array<TabledAlternative<AlphaToCoverage>>(
    {{AlphaToCoverage::proportional, "proportional", Openness::open,
      "the first samples of n; their number is alpha n rounded to nearest, a tie to the larger "
      "number"},
     {AlphaToCoverage::above_quotient, "above-quotient", Openness::open,
      "sample s of n where alpha is above s/n"},
     {AlphaToCoverage::above_quotient_of_others, "above-quotient-of-others", Openness::illegal,
      "sample s of n where alpha is above s/n; if the shader runs for each sample, the alphas of "
      "all other samples of the pixel must be, and its own need not"},
     {AlphaToCoverage::spread, "spread", Openness::open,
      "sample s of n where alpha is at least (s + 1)/(n + 1)"},
     {AlphaToCoverage::ignored, "ignored", Openness::illegal, "all samples, whatever alpha is"}});

// The mask of an alpha: bit s for sample s. NaN keeps nothing.
std::uint32_t alpha_mask(double alpha, int samples, AlphaToCoverage choice);

// For a shader that runs for each sample, under above_quotient_of_others: the samples that are
// written, and the invocations that run, by the alphas of all samples of a pixel, covered or not.
// An invocation does not run if an earlier one has cleared its sample.
std::uint32_t mask_by_others(std::span<const double> alphas);
std::uint32_t runs_by_others(std::span<const double> alphas);

// How many samples of a pixel the mask of an alpha in a range may keep, by ruling 33; the range may
// be everything.
struct SampleCounts {
  int least = 0;
  int most = 0;
};
SampleCounts alpha_permitted(Interval alpha, int samples);

// True if the number of samples kept, of a fragment that covers all, is proportional to alpha: less
// than one sample off alpha n, which permits any rounding, table or dither.
bool is_proportional(double alpha, int kept, int samples);

}  // namespace edgecase
