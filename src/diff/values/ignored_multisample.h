// SPDX-License-Identifier: MIT
//
// Consequences of a renderer's departure from ruling 35 without GL_MULTISAMPLE: samples that its
// fragments write, or do not write, and depths of other locations. They are reported with the same
// cause as their coverage.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "diff/values/value_diff.h"

namespace edgecase {

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

}  // namespace edgecase
