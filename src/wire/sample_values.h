// SPDX-License-Identifier: MIT
//
// Positions of samples, and how a draw makes use of them, as JSON: for src/wire alone. Readers
// throw a Refusal.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/sampling.h"
#include "wire/scene_values.h"

namespace edgecase::wire {

// [[x, y], ...] by sample index, in pixels from a pixel's lower left corner.
void write_positions(Output out, const SamplePositions& positions);

// The inverse: `samples` points, multiples of 2^-16 of 0 to below 1. There are none where the
// target has one sample.
SamplePositions read_positions(const nlohmann::json& value, const Path& path, int samples);

// The same as a renderer tells them: any numbers of 0 to below 1, of which the nearest multiples of
// 2^-16 below 1 are taken.
SamplePositions read_told_positions(const nlohmann::json& value, const Path& path, int samples);

// An object; of the mask, bits beyond the samples are left out.
void write_multisampling(Output out, const Multisampling& multisampling, int samples);

// The inverse. A mask of all samples is read as that of Multisampling: nothing is masked.
Multisampling read_multisampling(const nlohmann::json& value, const Path& path, int samples);

}  // namespace edgecase::wire
