// SPDX-License-Identifier: MIT
//
// Merging and resuming: the results of parts of a run become the results of the whole.
//
// Parts are the shards of one run, or runs of different cases under the same options. Their cases
// are put side by side, and all are judged again, together: the snap with which lines are read and
// the likeliest cause depend on the whole run. So merged shards equal, to the byte, one run of all
// cases. Answers that a part asked for twice stay as they are.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "results/results.h"
#include "suite/selection.h"

namespace edgecase {

// Results of a run, or of a part of one.
struct MergePart {
  std::string name;  // of its file, for messages
  Results results;
};

struct RunDifference {
  std::string what;    // "a.json was judged by policy opengl, b.json by policy cs184"
  std::string remedy;  // where the two are shards: "run all shards with one policy"
};

// The first difference of two runs in what decides on results besides the cases: version of the
// tool, policy, profiles, renderers. Answers of both may stand side by side only without one. A
// renderer that never answered differs from none of its name.
std::optional<RunDifference> difference_of_runs(const MergePart& a, const MergePart& b);

// True if no answer came from the renderer: then its version and traits are unknown.
bool has_never_answered(const RendererInfo& renderer);

// Merges at least one part. Returns a sentence instead if the parts do not belong together: another
// version of the tool, policy, renderer or suite, or a case or share that two of them have. A
// missing share is refused too, unless `partial` is set: then the results count as interrupted.
// Known faults are not applied, and the texts of case files are unknown.
std::variant<Results, std::string> merge_results(std::vector<MergePart> parts, bool partial);

// Resuming a run that ended early: the answers in its results are kept, and the remaining cases are
// run. Both, merged, equal to the byte the results of a run that was not interrupted.
//
// An answer is kept if the text of its case file is unchanged. Two kinds of cases are run again:
// those that depend on further files (meshes, images), which may have changed unnoticed, and those
// for which some renderer was unavailable. A crash or a time-out is an answer: if these were asked
// for again, a run could hang at one case for ever.

struct Resumption {
  Results held;  // the earlier results without the cases that are run again
  Suite rest;    // the cases still to be run, and all diagnostics
};

// Divides a suite. Returns a sentence instead if the earlier results hold a case that would be
// lost: its file exists, and the suite leaves it out. The caller checks that both are one run
// (difference_of_runs).
std::variant<Resumption, std::string> resume(const Suite& suite, MergePart earlier);

}  // namespace edgecase
