// SPDX-License-Identifier: MIT
//
// The results file, format 2: lines of JSON, packed (results/packed_stream.h), written and read one
// line at a time.
//
//   zstdcat out/results.zst | jq -c 'select(.case) | .case, .results'
//
// The same results give the same bytes: members stand in one order, cases are sorted, nothing says
// when or where the run took place. What was written reads back as it was, but for the text of case
// files, the primitives of places where values differ, and the pictures of cases where all agree.
// Lines are read as well where they are not packed. A member that says nothing is absent: an empty
// list or text, a number that is 0, -1 for what is counted from 0.
//
// The first line:
//
//   {"edgecase_results": 2, "tool", "policy", "latitude", "policy_digest", "whole_suite", "shard",
//    "renderers": [{"name", "vendor", "version", "device", "subpixel_bits", "traits"}]}
//
// "shard", absent but for a run that was divided, is {"index": from 1, "count", "cases": of the
// whole run, "selection": digest of them}; `edgecase merge` joins the shards.
//
// Cases, a line each, in the order of their ids:
//
//   {"case": ID, "head", "fragments", "expect_failures", "pixels", "samples", "figure",
//    "results": {RENDERER: {"verdict", "fingerprint", "standing", "standing_reason", "faults",
//    "again", "failure", "pixel_counts", "disagreements", "values", "evidence",
//    "illegal_line_snaps", "refuted", "exact_fragments", "rendered_fragments", "ramp", "pixels",
//    "samples", "exact_pixels", "exact_samples"}}}
//
// "head" is the number, counted from 0, of an earlier line that says what several cases share.
// Cases of a file stand together, and the heads that they name between them:
//
//   {"head": 0, "file", "file_digest", "title", "why", "rules", "spec", "origin", "tags",
//    "surface", "width", "height", "viewport"}
//
// "viewport", absent where it is the target's rectangle, is [x, y, width, height]: what the clip
// volume looks like in the window.
//
// Where every renderer agrees, as expected, a line has no "pixels", "samples" and "figure". Of
// others, a case's "pixels" are what exact draws, as a picture (results/packed_text.h). A result's
// are the exclusive or with exact's, as words, and absent where both are equal; "exact_pixels", of
// a renderer that was held against exact with samples elsewhere, the same with the case's. Of
// multisampled cases, a case and its results have "samples" (results/samples_json.h).
//
// A result's "standing" is absent where it is expected. Its "faults" are the ids of the known
// faults that account for something in it; "again", absent but for flakes, is {"verdict",
// "fingerprint"} of the answer that came when the renderer was asked a second time. Its
// "pixel_counts" are {"agree", "convention", "permitted", "contested", "violation", "same"}
// (model/result.h), and absent where nothing differs. A disagreement's "upright", absent but in
// answers that are told to be upside down, is {"rule", "ruling", "legality", "cause"} as they are
// without that (Disagreement::upright). "differing" of values are places (results/packed_text.h),
// "figure" is one of results/figure_json.h. "exact_fragments" and "rendered_fragments" are what
// either side makes where they differ (Result::exact_fragments, results/reported_fragments.h).
// "ramp" is a list of [x, y, exact, low, high, rendered]: levels of detail along a row of pixels
// (Result::ramp). Of supersampled cases, evidence has a "pass", and a disagreement's "sample" is a
// pass, both counted from 0; -1 is the image of all passes.
//
// The last line, without which a file is cut off:
//
//   {"end": true, "cases": number of them, "interrupted", "left_out", "diagnostics": [...],
//    "faults": [{"renderer", "id", "reason", "link", "cases", "state", "before"}], "summary",
//    "clusters": {RENDERER: [...]}}
//
// "left_out", absent where it is 0, says how many cases are missing since the run ended before
// them. "faults" are what the run shows of the known faults (FaultSeen); "before" is absent where
// the release has no count. Clusters (results/clusters.h) and the summary are counted from the
// cases, and not read back.
#pragma once

#include <iosfwd>
#include <string>
#include <variant>

#include "results/results.h"

namespace edgecase {

constexpr int kResultsFormat = 2;

// Writes lines as they are, or packed: the caller checks the stream's state afterwards.
void write_results(const Results& results, std::ostream& out);
void write_packed_results(const Results& results, std::ostream& out);

// What becomes of a file that is cut off: it is refused, or what it holds are the results of a run
// that was interrupted.
enum class Cut { refused, kept };

// Reads lines, packed or not; otherwise a sentence that says what is wrong and where, and what to
// do.
std::variant<Results, std::string> read_results(std::istream& in, Cut cut = Cut::refused);
std::variant<Results, std::string> read_results(const std::string& text, Cut cut = Cut::refused);

}  // namespace edgecase
