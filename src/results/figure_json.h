// SPDX-License-Identifier: MIT
//
// Figures in a results file: {"points": [x, y, x, y, ...], "marks": [[role, [index, ...], closed,
// label], ...]}.
//
// A mark names its points by their places in "points", counted from 0. A coordinate that is a whole
// number is one of 65536ths of a pixel, as exact positions are; any other is of pixels. "closed"
// and "label" are left out where they are what nearly all marks of the role have: an outline of
// three points is closed, a vertex is labelled with its position, a primitive with its number.
#pragma once

#include "model/figure.h"
#include "results/json_writer.h"
#include "results/shallow_json.h"

namespace edgecase {

void write_figure(JsonWriter& json, const Figure& figure);

// The inverse. Throws std::runtime_error, or what the library throws, for anything else.
Figure to_figure(const ReadJson& json);

// NaN and infinity are the strings "nan", "inf" and "-inf". Throws std::runtime_error for others.
double to_number(const ReadJson& json);

}  // namespace edgecase
