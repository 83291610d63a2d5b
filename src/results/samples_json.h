// SPDX-License-Identifier: MIT
//
// SampleImage in a results file: {"count", "positions": [[x, y], ...], "pixels", "hits",
// "coverage"}; members that were not reported are absent.
//
// Pixels and hits are stored sample by sample, coverage once, as packed words
// (results/packed_text.h). For a case, pixels are a picture of all planes, one above the other. For
// an answer, they are the exclusive or with those of the exact side with which it was compared, if
// that has as many.
#pragma once

#include <cstdint>
#include <vector>

#include "model/result.h"
#include "model/sample_image.h"
#include "results/json_writer.h"
#include "results/shallow_json.h"

namespace edgecase {

// Writes the multisampled image of a case that is `width` pixels wide.
void write_samples(JsonWriter& json, const SampleImage& image, int width);
// The same, as the difference from `exact`.
void write_samples(JsonWriter& json, const SampleImage& image, const SampleImage& exact);

// The inverses for an image of width x height pixels. They throw std::runtime_error if sizes do not
// fit.
SampleImage to_samples(const ReadJson& json, int width, int height);
SampleImage to_samples(const ReadJson& json, int width, int height, const SampleImage& exact);

// Each word's exclusive or with that of another list; the words as they are if the lengths differ.
std::vector<std::uint32_t> difference_of(std::vector<std::uint32_t> words,
                                         const std::vector<std::uint32_t>& others);

// Fragments in a results file: a list of [x, y, primitive, coverage, depth, [red, green, blue,
// alpha], pass].
//
// Depth or colour is null if it was not reported; only supersampled cases have a pass. Neighbours
// in a row that are equal in everything else are written once: x is then [x, number of them]. A
// number with a fraction is read as the nearest 32-bit float if its digits are the fewest that
// identify this float, and otherwise as it is; a number that would be mistaken for a float is a
// string.

void write_fragments(JsonWriter& json, const std::vector<Result::ReportedFragment>& fragments);

// Of all answers to a case together: reports tell them where something differs in full. They take
// 160 MB in memory.
constexpr std::size_t kMostFragments = std::size_t{1} << 21;

// The inverse, of at most `most` fragments. Throws std::runtime_error, or what the library throws,
// for anything else.
std::vector<Result::ReportedFragment> to_fragments(const ReadJson& json,
                                                   std::size_t most = kMostFragments);

}  // namespace edgecase
