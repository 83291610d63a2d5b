// SPDX-License-Identifier: MIT
//
// The samples of multisampled images in the report's data.
//
// {"count", "positions", "pixels", "hits", "coverage"}: positions are [x, y, x, y, ...] by sample;
// the others are packed as pixels.h says, four bytes for each item. Pixels and hits stand sample by
// sample within each pixel, since the samples of most pixels are alike; numbers have their lowest
// byte first. What was not told is left out.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/storage.h"

namespace edgecase {

nlohmann::ordered_json sample_data(const SampleImage& image);

// The same with pixels, hits and coverage as differences from those of `from`, which are nearly
// all zero. What `from` does not have is left out.
nlohmann::ordered_json sample_difference(const SampleImage& image, const SampleImage& from);

}  // namespace edgecase
