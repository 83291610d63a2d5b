// SPDX-License-Identifier: MIT
//
// The results file: a run's results as JSON, written and read.
//
// The same results give the same bytes: members stand in one order, cases are sorted, nothing says
// when or where the run took place. Cases stand on a line each, so that two files can be compared
// with ordinary tools. What was written reads back as it was, but for the text of case files.
//
//   {"tool", "policy", "latitude", "policy_digest", "interrupted", "left_out", "whole_suite",
//    "shard", "renderers": [{"name", "vendor", "version", "device", "subpixel_bits", "traits"}],
//    "cases": [{"id", "title", …, "results": {RENDERER: {"verdict", "fingerprint",
//    "pixel_counts", "disagreements": […], "values": […], …}}}], "diagnostics": […],
//    "faults": [{"renderer", "id", "reason", "link", "cases", "state", "before"}], "summary",
//    "clusters": {RENDERER: […]}}
//
// "shard", absent but for a run that was divided, is {"index": from 1, "count", "cases": of the
// whole run, "selection": digest of them}; `edgecase merge` joins the shards. "left_out", absent
// where it is 0, says how many cases are missing since the run ended before them.
//
// A result's "faults", absent where there are none, are the ids of the known faults that account
// for something in it; "again", absent but for flakes, is {"verdict", "fingerprint"} of the answer
// that came when the renderer was asked a second time. "faults" of the file are what the run shows
// of the known faults (FaultSeen); "before" is absent where the release has no count.
//
// A result's "pixel_counts", absent where it is not run, are {"agree", "convention", "permitted",
// "contested", "violation", "same"} (model/result.h).
//
// A disagreement's "upright", absent but in answers that are told to be upside down, is {"rule",
// "ruling", "legality", "cause"} as they are without that (Disagreement::upright).
//
// A result's "exact_fragments" and "rendered_fragments", absent where they are empty, are what
// either side makes where they differ (Result::exact_fragments): lists of [x, y, primitive,
// coverage, depth, [red, green, blue, alpha], pass], in which depth or colour is null where it was
// not told, and the pass is absent but of supersampled cases.
//
// A case's "viewport", absent where it is the target's rectangle, is [x, y, width, height]: what
// the clip volume looks like in the window.
//
// A result's "ramp", absent where it is empty, is a list of [x, y, exact, low, high, rendered]:
// levels of detail along a row of pixels (Result::ramp).
//
// Of multisampled cases, a case and its results have "samples" (samples_json.h), and a result that
// was held against exact with samples elsewhere "exact_pixels" and "exact_samples".
//
// Of supersampled cases, evidence has a "pass", and a disagreement's "sample" is a pass, both
// counted from 0; -1 is the image of all passes.
//
// Pictures are RGBA8 in hexadecimal digits, the bottom row first. A result's "pixels" are "exact"
// where they equal the case's. Of cases with more than 8,192 pixels a result has a "difference"
// instead, the exclusive or of the two, and whatever is long stands deflated or as runs
// (results/folding.h).
//
// Clusters (results/clusters.h) and the summary are counted from the cases, and not read back.
#pragma once

#include <iosfwd>
#include <string>
#include <variant>

#include "results/results.h"

namespace edgecase {

// The caller checks the stream's state afterwards.
void write_results(const Results& results, std::ostream& out);

// Reads what write_results wrote; otherwise a sentence that says what is wrong and where.
std::variant<Results, std::string> read_results(const std::string& text);

}  // namespace edgecase
