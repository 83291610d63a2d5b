// SPDX-License-Identifier: MIT
//
// What a comparison finds at single places, as the results file has it (results/results_json.h).
#pragma once

#include "model/result.h"
#include "results/json_writer.h"

namespace edgecase {

void write_disagreement(JsonWriter& json, const Disagreement& disagreement);
void write_evidence(JsonWriter& json, const Result::Evidence& evidence);
void write_values(JsonWriter& json, const ValueAggregate& values);

// [x, y, exact, low, high, rendered].
void write_level(JsonWriter& json, const Result::LevelPoint& point);

}  // namespace edgecase
