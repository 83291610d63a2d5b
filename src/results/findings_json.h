// SPDX-License-Identifier: MIT
//
// Disagreements, values, evidence and figures in the results file (results/results_json.h).
#pragma once

#include "model/figure.h"
#include "model/result.h"
#include "results/json_writer.h"
#include "results/shallow_json.h"

namespace edgecase {

// Figures in a results file: {"points": [x, y, x, y, ...], "marks": [[role, [index, ...], closed,
// label], ...]}.
//
// A mark names its points by their indices in "points", from 0. Coordinates that are whole numbers
// are in units of 1/65536 pixel, as exact positions are; others are in pixels. "closed" and "label"
// are absent if they have the usual value of the role: an outline of three points is closed, a
// vertex is labelled with its position, a primitive with its number.

void write_figure(JsonWriter& json, const Figure& figure);

// The inverse. Throws std::runtime_error, or what the library throws, for anything else.
Figure to_figure(const ReadJson& json);

// NaN and infinity are the strings "nan", "inf" and "-inf". Throws std::runtime_error for others.
double to_number(const ReadJson& json);

void write_disagreement(JsonWriter& json, const Disagreement& disagreement);
// The same without what only disagreements in full have, with "count" and, as "pixels", its runs
// (results/packed_text.h).
void write_counted(JsonWriter& json, const CountedDisagreements& counted);
void write_evidence(JsonWriter& json, const Result::Evidence& evidence);
void write_values(JsonWriter& json, const ValueAggregate& values);

// [x, y, exact, low, high, rendered].
void write_level(JsonWriter& json, const Result::LevelPoint& point);

}  // namespace edgecase
