// SPDX-License-Identifier: MIT
//
// What follows where a renderer does not do without GL_MULTISAMPLE what ruling 35 asks for: samples
// that its fragments write, or do not write, and depths of other places. It is told with the same
// cause as what they cover.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diff/values/value_diff.h"

namespace edgecase {

// That alternative of sample.enable.
Cause cause_of(MultisampleSwitch choice);

// The alternatives of sample.enable beside the policy's under which these fragments may write other
// samples; none, unless the switch is off for some of them.
std::vector<MultisampleSwitch> switches_beside(const ValueContext& context,
                                               std::span<const Fragment> fragments);

// covers_sample and last_writers of diff/values/value_diff.h under an alternative.
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

}  // namespace edgecase
