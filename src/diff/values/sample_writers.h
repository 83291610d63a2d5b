// SPDX-License-Identifier: MIT
//
// Which fragments write a sample of the target: those that cover it, less what alpha to coverage
// keeps from writing, under what the renderer does without GL_MULTISAMPLE.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "diff/values/value_diff.h"
#include "rules/samples/alpha_to_coverage.h"

namespace edgecase {

// Does the fragment cover the sample? Without multisampling it covers all.
bool covers_sample(const ValueContext& context, const Fragment& fragment, int sample);

// The fragments of a pixel, in drawing order, by which a sample may have been written last: the
// last one that covers it, and where alpha to coverage may have kept that from writing, those
// before it too, the last one first. Null stands for the clear value.
std::vector<const Fragment*> last_writers(const ValueContext& context,
                                          std::span<const Fragment> at_pixel, int sample);

// ------------------------------------------------------------------------------- alpha to coverage

// Of last_writers() those that their alphas leave, if those of 0 and 1 have been heeded.
std::vector<const Fragment*> left_by_alpha(const ValueContext& context,
                                           std::span<const Fragment* const> writers);

// Is the fragment's alpha what decides how many samples it writes?
bool is_thinned(const ValueContext& context, const Fragment& fragment);

// The samples that a fragment's alpha leaves under a choice, beside those that it does not cover.
// `at_pixel`: all fragments of its pixel.
std::uint32_t kept_by_alpha(const ValueContext& context, const Fragment& fragment,
                            std::span<const Fragment> at_pixel, AlphaToCoverage choice);

// How many of a target's samples a fragment that covers them all may write.
SampleCounts written_samples(const ValueContext& context, const Fragment& fragment);

// -------------------------------------------------------------------------- without GL_MULTISAMPLE
//
// What follows where a renderer does not do without GL_MULTISAMPLE what ruling 35 asks for: samples
// that its fragments write, or do not write, and depths of other places. It is told with the same
// cause as what they cover.

// That alternative of sample.enable.
Cause cause_of(MultisampleSwitch choice);

// The alternatives of sample.enable beside the policy's under which these fragments may write other
// samples; none, unless the switch is off for some of them.
std::vector<MultisampleSwitch> switches_beside(const ValueContext& context,
                                               std::span<const Fragment> fragments);

// covers_sample and last_writers under an alternative.
bool covers_sample(const ValueContext& context, const Fragment& fragment, int sample,
                   MultisampleSwitch choice);
std::vector<const Fragment*> last_writers(const ValueContext& context,
                                          std::span<const Fragment> at_pixel, int sample,
                                          MultisampleSwitch choice);

// Does the fragment give a sample that it covers its depth?
bool writes_depth(const ValueContext& context, const Fragment& fragment, int sample,
                  MultisampleSwitch choice);

// Where a fragment of a draw without GL_MULTISAMPLE has gl_FragCoord.xy and gl_FragCoord.z if that
// is ignored; none where the draw has it, or the target one sample.
std::optional<Point> coordinates_if_ignored(const ValueContext& context, const Fragment& fragment);
std::optional<Point> depth_place_if_ignored(const ValueContext& context, const Fragment& fragment,
                                            const LocationChoice& choice);

// ------------------------------------------------------------------------------------------ planes

// Planes like Rendering::sample_pixels. `nearest` is what is most likely, and each sample holds
// something between `low` and `high`, both inclusive.
struct SamplePlanes {
  std::vector<std::uint8_t> low;
  std::vector<std::uint8_t> nearest;
  std::vector<std::uint8_t> high;
};

// Whether what ruling 33 says of alphas of 0 and 1 is taken to have been heeded, where no hits say
// which samples alpha to coverage has left.
enum class AlphaEnds { heeded, open };

}  // namespace edgecase
