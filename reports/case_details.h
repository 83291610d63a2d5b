// SPDX-License-Identifier: MIT
//
// The details of one case in the HTML report, beyond its line in the list, as JSON.
//
// {"pixels", "samples", "viewport", "figure", "expect_failures", "answers", "results"}. Renderers
// with equal answers share one entry of "answers" (pixels, disagreements, values, fragments,
// evidence). "results" has one entry per renderer, in their order: "answer" (an index),
// "standing_reason", "faults", "again", "failure", and "pixel_counts", its pixels by kind
// (model/result.h). Pixels are packed as pixels.h says; an answer's are the difference from exact
// and absent when there is none; an answer without an image of exact's size is "blank". A case's
// "viewport", [x, y, width, height], is absent where it is the target's rectangle. A multisampled
// case has "samples" (sample_data.h), and so has an answer; a disagreement names its "sample" where
// it is about one. An answer that was compared with exact at other sample positions has "exact":
// {"difference", "samples"}, its difference from the case's. An answer's "fragments" are those of
// "exact" and "rendered" at listed disagreements, each as in the results file
// (results/results_json.h). In a supersampled case, evidence has its "pass", counted from 0, and a
// disagreement's explanation begins with it. An answer with levels of detail along a row of pixels
// has a "ramp": "points" is a list of [x, y, exact, low, high, rendered], "outside" the indices of
// those outside the band, "farthest" the index of the one farthest from exact where they are not
// equal, "words" a sentence (ramp.h). A figure is a list of [role, closed, label, [x, y, x, y,
// ...]]. Numbers that JSON lacks are the strings "NaN", "Infinity", "-Infinity".
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "results/results.h"

namespace edgecase {

// The report shows at most this many disagreements of an answer, and the number of the others that
// the results file has in full ("omitted"). Of a gross fault the rest have a line of text for each
// kind ("counted"), and "total" is the number of all.
constexpr std::size_t kMaxDisagreementsPerAnswer = 2000;

nlohmann::ordered_json case_details(const CaseResults& one);

// {"agree": ..., "same": ...}: pixels by verdict, and those of exact's colour.
nlohmann::ordered_json pixel_counts_json(const PixelCounts& counts);

}  // namespace edgecase
