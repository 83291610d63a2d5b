// SPDX-License-Identifier: MIT
//
// The results file, format 2: lines of JSON, packed (results/packed_text.h), written and read one
// line at a time.
//
//   zstdcat out/results.zst | jq -c 'select(.case) | .case, .results'
//
// The same results give the same bytes: members have a fixed order, cases are sorted, and time and
// place of the run are not written. Results read back as they were, except for the text of case
// files, the primitives of places where values differ, and the pictures of cases where all agree.
// Plain lines can be read, too. A member with its default is absent: an empty list or text, the
// number 0, or -1 for an index.
//
// The first line:
//
//   {"edgecase_results": 2, "tool", "policy", "latitude", "policy_digest", "whole_suite", "shard",
//    "renderers": [{"name", "vendor", "version", "device", "subpixel_bits", "traits"}]}
//
// "shard", present only for a share of a run, is {"index": from 1, "count", "cases": of the whole
// run, "selection": digest of them, "faulty": cases of this share that are lost by faults of their
// files, if there are any}; `edgecase merge` joins the shards.
//
// Cases, a line each, in the order of their ids:
//
//   {"case": ID, "head", "fragments", "expect_failures", "pixels", "samples", "figure",
//    "results": {RENDERER: {"verdict", "fingerprint", "answer_digest", "images",
//    "standing", "standing_reason", "faults", "again", "failure", "pixel_counts", "disagreements",
//    "counted", "values", "evidence", "illegal_line_snaps", "refuted", "exact_fragments",
//    "rendered_fragments", "shown", "ramp", "pixels", "samples", "exact_pixels", "exact_samples"}}}
//
// "head" is the number, from 0, of an earlier line with the fields that several cases share. Cases
// of a file are consecutive, with their heads between them:
//
//   {"head": 0, "file", "file_digest", "title", "why", "rules", "spec", "origin", "tags",
//    "surface", "width", "height", "viewport"}
//
// "viewport", absent if it is the target's rectangle, is [x, y, width, height]: the clip volume in
// the window.
//
// If every renderer agrees, as expected, a line has no "pixels", "samples" and "figure". Otherwise
// a case's "pixels" are exact's picture (results/packed_text.h). A result's "pixels" are the
// exclusive or with exact's, as words, and absent if both are equal. "exact_pixels", present if the
// renderer was compared with exact with samples elsewhere, are the same with the case's.
// Multisampled cases and their results have "samples" (results/samples_json.h).
//
// A result's "answer_digest" is 16 hexadecimal digits, and absent if it is unknown. It is of the
// answer as it came: the bytes of a worker and the line of its recording have two. "images",
// present if the scene has images (diff/invariance.h), are [drawn, refused]. Its "standing" is
// absent if it is expected. Its "faults" are the ids of the known faults that account for something
// in it; "again", present for flakes only, is {"verdict", "fingerprint"} of the second answer. Its
// "pixel_counts" are {"agree", "convention", "permitted", "contested", "violation", "same"}
// (model/result.h), and absent if nothing differs. A disagreement's "upright", present only in
// answers that are reported as upside down, is {"rule", "ruling", "legality", "cause"} without that
// (Disagreement::upright). Of a gross fault "disagreements" are the first, and the rest are
// "counted": a member for each class of them (CountedDisagreements), with the members of a
// disagreement that its class has, their number as "count", and their "pixels" as runs
// (results/packed_text.h). "differing" of values are places
// (results/packed_text.h), "figure" is one of results/findings_json.h. "exact_fragments" and
// "rendered_fragments" are what either side makes where they differ (Result::exact_fragments,
// results/samples_json.h). "ramp" is a list of [x, y, exact, low, high, rendered]: levels of detail
// along a row of pixels (Result::ramp). "shown" is a list of [thing, of, sample, low, high] and,
// of an alpha, x and y, or of [thing, of, sample, cells]: what the answer shows of things that are
// one in all answers (Result::shown). Of supersampled cases, evidence has a "pass", and a
// disagreement's "sample" is a pass, both counted from 0; -1 is the image of all passes.
//
// While a run goes on, what it has finished lies in a file of this format that is cut off: the
// cases in any order, each behind a head of its own, and the first line again whenever more is
// known of the renderers; the last one counts. Every few lines are a frame of Zstandard.
//
// The last line, without which a file is cut off:
//
//   {"end": true, "cases": number of them, "interrupted", "left_out", "diagnostics": [...],
//    "faults": [{"renderer", "id", "reason", "link", "cases", "state", "before"}], "summary",
//    "portraits": {RENDERER: [sentence, ...]}, "refuted": {RENDERER: {SURFACE: bits}}, "rules":
//    {RENDERER: {SURFACE: [{"rule", "asked", "remain", "for": {ALTERNATIVE: answers}}]}},
//    "clusters": {RENDERER: [...]}}
//
// "left_out", absent if it is 0, is the number of cases that are missing because the run ended
// early. "faults" are the known faults as they occur in the run (FaultSeen); "before" is absent if
// the release has no count. Portraits (rules/portrait.h), clusters (results/clusters.h) and the
// summary are computed from the cases, and not read back.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

#include "results/results.h"

namespace edgecase {

constexpr int kResultsFormat = 2;

// The first line, and a case's line behind that of its head, which has the same number: what a file
// that grows case by case is made of.
std::string header_line(const Results& results);
std::string case_lines(const CaseResults& one, std::size_t number,
                       const std::vector<RendererInfo>& renderers);

// Writes lines as they are, or packed: the caller checks the stream's state afterwards.
void write_results(const Results& results, std::ostream& out);
void write_packed_results(const Results& results, std::ostream& out);

// A file that is cut off is refused, or is read as the results of an interrupted run.
enum class Cut { refused, kept };

// Reads lines, packed or not. Otherwise a sentence that says what is wrong, where, and what to do.
std::variant<Results, std::string> read_results(std::istream& in, Cut cut = Cut::refused);
std::variant<Results, std::string> read_results(const std::string& text, Cut cut = Cut::refused);

}  // namespace edgecase
