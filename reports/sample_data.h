// SPDX-License-Identifier: MIT
//
// The samples of multisampled images in the report's data.
//
// {"count", "positions", "pixels", "hits", "coverage"}: positions are [x, y, x, y, ...] by sample;
// the others are packed by pixels.h, four bytes for each item. Pixels and hits are ordered by
// pixel, then by sample, since the samples of most pixels are equal; numbers have their lowest byte
// first. Unreported members are omitted.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/sample_image.h"

namespace edgecase {

nlohmann::ordered_json sample_data(const SampleImage& image);

// The same, with pixels, hits and coverage as differences from those of `from`, which are nearly
// all zero. Members that `from` lacks are omitted.
nlohmann::ordered_json sample_difference(const SampleImage& image, const SampleImage& from);

}  // namespace edgecase
