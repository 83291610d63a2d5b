// SPDX-License-Identifier: MIT
//
// GL_MULTISAMPLE and the sample mask (GL 4.6 core, 14.3.1 and 14.9.3).
//
// While GL_MULTISAMPLE is disabled, a multisampled target is drawn to as though it had one sample.
// A fragment then writes every sample of its pixel. While GL_MULTISAMPLE is enabled, glSampleMaski
// says which samples may be written. The mask is ANDed with the primitive's coverage before the
// shader runs. gl_SampleMaskIn therefore shows the masked coverage. A pixel whose masked coverage
// is empty has no fragment.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "model/sampling.h"
#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

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

}  // namespace edgecase
