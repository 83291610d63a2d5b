// SPDX-License-Identifier: MIT
//
// What the samples of a multisampled target hold, where a renderer need not say it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "diff/values/value_diff.h"
#include "rules/samples/alpha_to_coverage.h"

namespace edgecase {

// Planes like Rendering::sample_pixels. `nearest` is what is most likely, and each sample holds
// something between `low` and `high`, both inclusive.
struct SamplePlanes {
  std::vector<std::uint8_t> low;
  std::vector<std::uint8_t> nearest;
  std::vector<std::uint8_t> high;
};

// As the renderer tells them; it must have done so.
SamplePlanes told_samples(const Rendering& rendered);

// Whether what ruling 33 says of alphas of 0 and 1 is taken to have been heeded, where no hits say
// which samples alpha to coverage has left.
enum class AlphaEnds { heeded, open };

// As the renderer's own fragments, and its hits if it tells them, put them there: each sample holds
// the colour of the fragment by which it was written last, or the clear colour.
SamplePlanes inferred_samples(const ValueContext& context, const Rendering& rendered,
                              AlphaEnds ends);

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

}  // namespace edgecase
