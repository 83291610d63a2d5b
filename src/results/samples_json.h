// SPDX-License-Identifier: MIT
//
// SampleImage in a results file: {"count", "positions": [[x, y], ...], "pixels": hex, "hits",
// "coverage"}; what was not told is left out.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/sample_image.h"

namespace edgecase {

// Null where the image is not multisampled.
nlohmann::ordered_json samples_json(const SampleImage& image);

// The inverse for an image of width x height pixels. Throws std::runtime_error where sizes do not
// fit.
SampleImage to_samples(const nlohmann::json& json, int width, int height);

}  // namespace edgecase
