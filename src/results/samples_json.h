// SPDX-License-Identifier: MIT
//
// SampleImage in a results file: {"count", "positions": [[x, y], ...], "pixels", "hits",
// "coverage"}; what was not told is left out.
//
// Pixels and hits stand sample by sample, coverage once, as packed words (results/packed_text.h).
// A case has them as they are, and its pixels as a picture of all planes, one above the other.
// Answers have the exclusive or with those of the exact side that they were held against, where
// that has as many.
#pragma once

#include <cstdint>
#include <vector>

#include "model/storage.h"
#include "results/json_writer.h"
#include "results/shallow_json.h"

namespace edgecase {

// Of an image that is multisampled, of a case `width` pixels wide.
void write_samples(JsonWriter& json, const SampleImage& image, int width);
// As it differs from `exact`.
void write_samples(JsonWriter& json, const SampleImage& image, const SampleImage& exact);

// The inverses for an image of width x height pixels. Throw std::runtime_error where sizes do not
// fit.
SampleImage to_samples(const ReadJson& json, int width, int height);
SampleImage to_samples(const ReadJson& json, int width, int height, const SampleImage& exact);

// Each word's exclusive or with that of another list, where that is as long; otherwise the words.
std::vector<std::uint32_t> difference_of(std::vector<std::uint32_t> words,
                                         const std::vector<std::uint32_t>& others);

}  // namespace edgecase
