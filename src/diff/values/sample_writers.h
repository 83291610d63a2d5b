// SPDX-License-Identifier: MIT
//
// The fragments that write a sample of the target: those that cover it, less those that alpha to
// coverage keeps from writing, under the renderer's behaviour without GL_MULTISAMPLE.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "diff/values/value_diff.h"
#include "rules/samples/sample_mask.h"

namespace edgecase {

// True if the fragment covers the sample. Without multisampling it covers all.
bool covers_sample(const ValueContext& context, const Fragment& fragment, int sample);

// The fragments of a pixel, in drawing order, that may have written a sample last: the last one
// that covers it and, if alpha to coverage may have kept that from writing, those before it too,
// the last one first. Null stands for the clear value.
std::vector<const Fragment*> last_writers(const ValueContext& context,
                                          std::span<const Fragment> at_pixel, int sample);

// ------------------------------------------------------------------------------- alpha to coverage

// Those of last_writers() that remain by their alphas, if those of 0 and 1 have been heeded.
std::vector<const Fragment*> left_by_alpha(const ValueContext& context,
                                           std::span<const Fragment* const> writers);

// True if the fragment's alpha decides how many samples it writes.
bool is_thinned(const ValueContext& context, const Fragment& fragment);

// The samples that a fragment's alpha leaves under a choice, whether it covers them or not.
// `at_pixel`: all fragments of its pixel.
std::uint32_t kept_by_alpha(const ValueContext& context, const Fragment& fragment,
                            std::span<const Fragment> at_pixel, AlphaToCoverage choice);

// How many of a target's samples a fragment may write that covers them all.
SampleCounts written_samples(const ValueContext& context, const Fragment& fragment);

// -------------------------------------------------------------------------- without GL_MULTISAMPLE
//
// Consequences of a renderer's departure from ruling 35 without GL_MULTISAMPLE: samples that its
// fragments write, or do not write, and depths of other locations. They are reported with the same
// cause as their coverage.

// The alternative of sample.enable.
Cause cause_of(MultisampleSwitch choice);

// The alternatives of sample.enable besides the policy's under which these fragments may write
// other samples; none, unless the switch is off for some of them.
std::vector<MultisampleSwitch> switches_beside(const ValueContext& context,
                                               std::span<const Fragment> fragments);

// covers_sample and last_writers under an alternative.
bool covers_sample(const ValueContext& context, const Fragment& fragment, int sample,
                   MultisampleSwitch choice);
std::vector<const Fragment*> last_writers(const ValueContext& context,
                                          std::span<const Fragment> at_pixel, int sample,
                                          MultisampleSwitch choice);

// True if the fragment gives its depth to a sample that it covers.
bool writes_depth(const ValueContext& context, const Fragment& fragment, int sample,
                  MultisampleSwitch choice);

// The locations of gl_FragCoord.xy and gl_FragCoord.z for a fragment of a draw without
// GL_MULTISAMPLE, if that is ignored; none if the draw has it, or the target one sample.
std::optional<Point> coordinates_if_ignored(const ValueContext& context, const Fragment& fragment);
std::optional<Point> depth_place_if_ignored(const ValueContext& context, const Fragment& fragment,
                                            const LocationChoice& choice);

// ------------------------------------------------------------------------------------------ planes

// Planes like Rendering::sample_pixels. `nearest` is the most likely, and each sample holds a value
// between `low` and `high`, both inclusive.
struct SamplePlanes {
  std::vector<std::uint8_t> low;
  std::vector<std::uint8_t> nearest;
  std::vector<std::uint8_t> high;
};

// Whether to assume that ruling 33 on alphas of 0 and 1 was heeded, if no hits show which samples
// alpha to coverage has left.
enum class AlphaEnds { heeded, open };

}  // namespace edgecase
