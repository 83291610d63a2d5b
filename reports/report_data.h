// SPDX-License-Identifier: MIT
//
// The data of the HTML report, as JSON.
//
// {"tool", "policy", "interrupted", "left_out", "renderers", "rules", "rulings", "diagnostics",
// "missing", "cases"}. A case holds the words of its file, its exact pixels, its figure, "answers"
// and "results": two renderers that answered alike share one answer (pixels, disagreements, values,
// evidence), a result adds what is each renderer's own (verdict, standing, failure, expectation,
// and how many of its pixels fare how: "pixel_counts", model/result.h). Pixels are packed as
// pixels.h says; an answer's are the difference from exact and absent when there is none; an answer
// without an image of exact's size is "blank". A multisampled case has "samples" (sample_data.h),
// and so has an answer; a disagreement names its "sample" where it is about one. An answer that was
// held against exact with samples elsewhere has that as "exact": {"difference", "samples"}, told by
// its difference from the case's. Of a supersampled case, evidence has the "pass" it is about,
// counted from 0; a disagreement's explanation begins with its own. A renderer holds its "clusters"
// (results/clusters.h) in their order. An answer with levels of detail along a row of pixels has a
// "ramp": "points" is a list of [x, y, exact, low, high, rendered], "outside" the indices of those
// outside the band, "farthest" the index of the one farthest from exact where they are not equal,
// "words" a sentence (ramp.h). A figure is a list of [role, closed, label, [x, y, x, y, ...]].
// Numbers that JSON lacks are the strings "NaN", "Infinity", "-Infinity".
#pragma once

#include <cstddef>
#include <string>

#include "reports/html.h"

namespace edgecase {

// An answer with more disagreements than this shows the first so many in the report and names the
// number of the rest ("omitted"); the results file is complete.
constexpr std::size_t kMaxDisagreementsPerAnswer = 2000;

// Valid UTF-8 (invalid bytes become U+FFFD) in which `<` occurs only as \u003c, so that no text can
// end the script element around it.
std::string report_data(const Results& results, const ReportTexts& texts);

}  // namespace edgecase
