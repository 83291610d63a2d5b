// SPDX-License-Identifier: MIT
//
// What the HTML report holds of one case beyond its line in the list, as JSON.
//
// {"pixels", "samples", "viewport", "figure", "expect_failures", "answers", "results"}. Two
// renderers that answered alike share one of "answers" (pixels, disagreements, values, fragments,
// evidence); "results" adds what is each renderer's own, in their order: "answer" (its index),
// "standing_reason", "faults", "again", "failure", and how many of its pixels fare how:
// "pixel_counts" (model/result.h). Pixels are packed as pixels.h says; an answer's are the
// difference from exact and absent when there is none; an answer without an image of exact's size
// is "blank". A case's "viewport", [x, y, width, height], is absent where it is the target's
// rectangle. A multisampled case has "samples" (sample_data.h), and so has an answer; a
// disagreement names its "sample" where it is about one. An answer that was held against exact with
// samples elsewhere has that as "exact": {"difference", "samples"}, told by its difference from the
// case's. An answer's "fragments" are what "exact" and "rendered" make at disputed pixels, each as
// the results file lists it (results/results_json.h), as far as disagreements are listed. Of a
// supersampled case, evidence has the "pass" it is about, counted from 0; a disagreement's
// explanation begins with its own. An answer with levels of detail along a row of pixels has a
// "ramp": "points" is a list of [x, y, exact, low, high, rendered], "outside" the indices of those
// outside the band, "farthest" the index of the one farthest from exact where they are not equal,
// "words" a sentence (ramp.h). A figure is a list of [role, closed, label, [x, y, x, y, ...]].
// Numbers that JSON lacks are the strings "NaN", "Infinity", "-Infinity".
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "results/results.h"

namespace edgecase {

// An answer with more disagreements than this shows the first so many in the report and names the
// number of the rest ("omitted"); the results file is complete.
constexpr std::size_t kMaxDisagreementsPerAnswer = 2000;

nlohmann::ordered_json case_details(const CaseResults& one);

}  // namespace edgecase
