// SPDX-License-Identifier: MIT
//
// The fragments that write a sample of the target: those that cover it, less those that alpha to
// coverage keeps from writing, under the renderer's behaviour without GL_MULTISAMPLE.
#pragma once

#include <cstdint>
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

}  // namespace edgecase
