// SPDX-License-Identifier: MIT
//
// Fragments in a results file: a list of [x, y, primitive, coverage, depth, [red, green, blue,
// alpha], pass].
//
// Depth or colour is null where it was not told; the pass is absent but of supersampled cases.
// Neighbours in a row that are alike in all else are told once: x is then [x, number of them]. A
// number with a fraction is the 32-bit float that is nearest to it, where its digits are the fewest
// that tell this float from others, and otherwise itself; a number that would be mistaken for a
// float is a string.
#pragma once

#include <vector>

#include "model/result.h"
#include "results/json_writer.h"
#include "results/shallow_json.h"

namespace edgecase {

void write_fragments(JsonWriter& json, const std::vector<Result::ReportedFragment>& fragments);

// The inverse. Throws std::runtime_error, or what the library throws, for anything else.
std::vector<Result::ReportedFragment> to_fragments(const ReadJson& json);

}  // namespace edgecase
