// SPDX-License-Identifier: MIT
//
// What a comparison finds at single places, as the results file has it (results/results_json.h).
#pragma once

#include "model/result.h"
#include "results/json_writer.h"

namespace edgecase {

void write_mark(JsonWriter& json, const Mark& mark);
void write_disagreement(JsonWriter& json, const Disagreement& disagreement);
void write_evidence(JsonWriter& json, const Result::Evidence& evidence);

// [x, y, primitive, coverage, depth, [red, green, blue, alpha], pass].
void write_fragment(JsonWriter& json, const Result::ReportedFragment& told);

// [x, y, exact, low, high, rendered].
void write_level(JsonWriter& json, const Result::LevelPoint& point);

// [x, y, primitive].
void write_place(JsonWriter& json, const ValueAggregate::Place& place);

}  // namespace edgecase
