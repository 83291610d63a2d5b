// SPDX-License-Identifier: MIT
//
// SampleImage in a results file: {"count", "positions": [[x, y], ...], "pixels": hex, "hits",
// "coverage"}; what was not told is left out.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/storage.h"
#include "results/json_writer.h"

namespace edgecase {

// Of an image that is multisampled.
void write_samples(JsonWriter& json, const SampleImage& image);

// The inverse for an image of width x height pixels. Throws std::runtime_error where sizes do not
// fit.
SampleImage to_samples(const nlohmann::json& json, int width, int height);

}  // namespace edgecase
