// SPDX-License-Identifier: MIT
//
// State that takes samples from a fragment: GL_MULTISAMPLE, the sample mask, and alpha as coverage.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "exact/interval.h"
#include "model/sampling.h"
#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

// Essay: GL_MULTISAMPLE and the sample mask
//
// GL_MULTISAMPLE and the sample mask (GL 4.6 core, 14.3.1 and 14.9.3).
//
// While GL_MULTISAMPLE is disabled, a multisampled target is drawn to as though it had one sample.
// A fragment then writes every sample of its pixel. While GL_MULTISAMPLE is enabled, glSampleMaski
// says which samples may be written. The mask is ANDed with the primitive's coverage before the
// shader runs. gl_SampleMaskIn therefore shows the masked coverage. A pixel whose masked coverage
// is empty has no fragment.

Rule multisample_switch_rule();  // sample.enable
Rule sample_mask_rule();         // sample.mask

enum class MultisampleSwitch {
  honoured,
  depth_of_first,  // but only sample 0 is given a depth
  ignored,
  ignored_but_for_lines,    // points and triangles ignore it
  ignored_but_whole_lines,  // the same; lines honour it, but their fragments have all bits
};
template <>
inline constexpr auto kNames<MultisampleSwitch> = std::to_array<
    TabledAlternative<MultisampleSwitch>>(
    {{MultisampleSwitch::honoured, "honoured", Openness::mandated,
      "without GL_MULTISAMPLE the pixel's centre decides for all samples"},
     {MultisampleSwitch::depth_of_first, "depth-of-first", Openness::illegal,
      "the pixel's centre decides for all samples, and only sample 0 gets a depth"},
     {MultisampleSwitch::ignored, "ignored", Openness::illegal,
      "each sample decides for itself, whether GL_MULTISAMPLE is enabled or not; the sample mask "
      "applies only while it is enabled"},
     {MultisampleSwitch::ignored_but_for_lines, "ignored-but-for-lines", Openness::illegal,
      "honoured for lines, ignored for points and triangles"},
     {MultisampleSwitch::ignored_but_whole_lines, "ignored-but-whole-lines", Openness::illegal,
      "ignored for points and triangles; for lines the pixel's centre decides for all samples, and "
      "the coverage has the bits of all samples"}});

// How a draw without GL_MULTISAMPLE is drawn on a multisampled target.
enum class Unsampled {
  by_centre,       // the pixel's centre decides for all samples; coverage is bit 0
  whole_pixels,    // the pixel's centre decides for all samples; coverage has all bits
  by_each_sample,  // as with GL_MULTISAMPLE
};
Unsampled unsampled(PrimitiveKind kind, MultisampleSwitch choice);

enum class SampleMask { applied, ignored };
template <>
inline constexpr auto kNames<SampleMask> = std::to_array<TabledAlternative<SampleMask>>(
    {{SampleMask::applied, "applied", Openness::mandated,
      "samples whose bit is clear are not covered"},
     {SampleMask::ignored, "ignored", Openness::illegal, "the mask changes nothing"}});

// Bit s for each of so many samples.
constexpr std::uint32_t mask_of_all(int samples) {
  return (std::uint32_t{1} << samples) - 1;
}

// The samples that a draw may write: all, if multisampling is not enabled.
std::uint32_t writable_samples(const Multisampling& use, int samples, SampleMask choice);

// Essay: Alpha as coverage
//
// Alpha to coverage (GL 4.6 core, 17.3.1).
//
// GL_SAMPLE_ALPHA_TO_COVERAGE turns the alpha that the shader writes into a mask. The mask is ANDed
// with the fragment's coverage. The number of its ones is proportional to alpha: all of them for 1,
// none for 0. Everything else about the mask is open, and it may differ from pixel to pixel. Every
// implementation that we know sets bits from sample 0 upward as alpha passes thresholds.

Rule alpha_to_coverage_rule();  // sample.alpha-to-coverage
inline constexpr int kRulingOnProportion = 52;
inline constexpr int kRulingOnFallingNumbers = 69;  // in several answers

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
