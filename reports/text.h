// SPDX-License-Identifier: MIT
//
// The few phrases that every report shares, so that JUnit, the terminal and HTML tell one story.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "results/comparison.h"
#include "results/results.h"

namespace edgecase {

// `text` as XML 1.0 can hold it, nothing dropped: control characters become their pictures
// (U+2400 to U+2421), invalid UTF-8 and U+FFFE, U+FFFF become U+FFFD. Tab and line feed stay. A
// space breaks what a log of GitHub's would obey: "::" at the beginning of a line, and "##[".
std::string xml_text(std::string_view text);

// The same on one line: tabs and line feeds become their pictures too, and marks that turn the
// direction of text U+FFFD, so that what stands beside the text keeps its place.
std::string one_line(std::string_view text);

// The text, or of a longer one its first characters, at most `most` bytes of them, and how many
// bytes are left out: "begins so… (9000 bytes more)".
std::string shortened(std::string_view text, std::size_t most);

// Disagreements, and values that differ inside what is permitted.
std::size_t count_differences(const Result& result);

// "and 1,044,480 more, missing, triangle.fill-rule, not allowed by ruling 4": the disagreements
// that are only counted (Result::counted), a line for each kind, rule, ruling, legality and cause,
// the worst first.
std::vector<std::string> describe_counted(const Result& result);

// "violation, unexpected, 3 disagreements": verdict, standing and counts of a result.
std::string headline(const Result& result);

// "The run was interrupted; 3 cases are missing."
std::string words_of_interruption(const Results& results);

// "egl:softpipe drew none of 59 cases: 50 x "REASON", 9 x "REASON"" with at most six reasons; of a
// shard, that the others decide.
std::string words_of_idleness(const Results& results, std::size_t renderer);

// Is it about one sample of a pixel of so many?
bool names_sample(const Disagreement& disagreement, int samples);

// "pixel (3, 4)"; "pixel (3, 4), sample 0" where it names one of so many samples.
std::string place_of(const Disagreement& disagreement, int samples);

// "pixel (3, 4), missing, line.diamond-exit, not allowed: EXPLANATION", of a case of so many
// samples.
std::string describe(const Disagreement& disagreement, int samples);

// ", 17 to 19 permitted"; empty where the bounds are not known.
std::string describe_permitted(const ValueAggregate& values);

// "color: 12 of 340 values differ within what is permitted, worst 1 ULP at pixel (3, 4): 0.5 exact,
// 0.50000006 rendered".
std::string describe(const ValueAggregate& values);

// "98 cases, 96 are known on this release": what a run shows of a known fault.
std::string describe(const FaultSeen& seen);

// What a change means, as a heading says it: "new disagreements", "not run any more".
const char* describe(ChangeKind change);

// Why a result is what it is, as its first sentence: the failure's reason, the first disagreement
// or the first value that differs, else the standing's reason; may be empty.
std::string first_explanation(const Result& result, int samples);

}  // namespace edgecase
