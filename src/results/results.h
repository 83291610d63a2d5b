// SPDX-License-Identifier: MIT
//
// Results: everything that one run found, in memory. src/diff fills in verdicts, results/standing.h
// the standing of answers; results/results_json.h writes the file, and reports show it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/case.h"
#include "model/figure.h"
#include "model/names.h"
#include "model/policy.h"
#include "model/renderer.h"
#include "model/result.h"
#include "results/case_list.h"
#include "rules/portrait.h"
#include "rules/rule_answers.h"

namespace edgecase {

// More than anybody compares at a time. A line of results names all renderers, and reports have a
// column for each.
constexpr std::size_t kMostRenderers = 256;
constexpr int kMostShards = 1'000'000;

// Which share of a run's cases results hold.
struct ShareOfRun {
  int index = 0;  // 0 to count - 1
  int count = 1;
  std::size_t cases = 0;  // of the run as a whole
  std::string selection;  // digest of their ids and of their files' texts
  // Cases of this share that it lacks, since faults showed when their file was read as a whole.
  std::size_t faulty = 0;
  friend bool operator==(const ShareOfRun&, const ShareOfRun&) = default;
};

// The number of cases of a known fault against its file's count for the release
// (KnownFault::cases_on).
enum class FaultState {
  known,      // as many cases as the file says, or it says nothing and the suite was not run whole
  grown,      // more cases: red
  shrunk,     // fewer cases
  fixed,      // none
  uncounted,  // the file has no count of this release
};

template <>
inline constexpr auto kNames<FaultState> =
    std::to_array<Named<FaultState>>({{FaultState::known, "known"},
                                      {FaultState::grown, "grown"},
                                      {FaultState::shrunk, "shrunk"},
                                      {FaultState::fixed, "fixed"},
                                      {FaultState::uncounted, "uncounted"}});

// The occurrence of one known fault of a renderer's driver in a run.
struct FaultSeen {
  std::string renderer;  // name
  std::string id;
  std::string reason;
  std::string link;                   // or empty
  std::size_t cases = 0;              // for which it accounts at least in part
  std::optional<std::size_t> before;  // the file's count of this release, if it has one
  FaultState state = FaultState::known;
  friend bool operator==(const FaultSeen&, const FaultSeen&) = default;
};

struct Results {
  std::string tool;    // "edgecase 0.1.0"
  std::string policy;  // name
  Latitude latitude = Latitude::opengl;
  std::string policy_digest;  // of the policy's choices, and of the renderers' profiles
  std::vector<RendererInfo> renderers;
  CaseList cases;                       // sorted by id
  std::vector<Diagnostic> diagnostics;  // case files that could not be loaded
  bool interrupted = false;             // the run ended before all cases were done
  std::size_t left_out = 0;             // cases that are missing for this reason
  // All files of the suite's folder were selected, and none of their cases was excluded.
  bool whole_suite = false;
  std::optional<ShareOfRun> shard;  // of a run that was divided among several
  // By renderer, then in the order of its driver's file. If results are not whole, only faults that
  // occurred, and none is grown, shrunk or fixed.
  std::vector<FaultSeen> faults;
  // Renderer, then surface: the alternatives that some of its answers refute.
  std::map<std::string, std::map<std::string, AlternativeSet>> refuted;
  // Renderer, then surface: what its answers say of each rule about which they were asked.
  std::map<std::string, std::map<std::string, std::vector<RuleAnswers>>> rules;
};

// True if the results hold every case of the suite.
inline bool is_whole(const Results& results) {
  return results.whole_suite && !results.shard && !results.interrupted &&
         results.diagnostics.empty();
}

// The number of unexpected answers, flakes included, of all renderers or of the one at `renderer`.
std::size_t count_unexpected(const Results& results);
std::size_t count_unexpected(const Results& results, std::size_t renderer);

// A reason by which a renderer refused cases as unsupported, and how many.
struct Refusal {
  std::string reason;
  std::size_t cases = 0;
};
// Of the renderer at `renderer`, most cases first, equals by reason.
std::vector<Refusal> refusals_of(const Results& results, std::size_t renderer);

// True if the renderer drew no case at all and refused at least one. Such a run says nothing of the
// renderer, and is red. False of an interrupted run, which does not tell.
bool drew_nothing(const Results& results, std::size_t renderer);
// The renderers of which that is so, by index; none of a shard, whose neighbours may have drawn.
std::vector<std::size_t> idle_renderers(const Results& results);

// What all answers of the renderer at `renderer` together say of it.
Portrait portrait_of(const Results& results, std::size_t renderer);

// verdict -> number of cases, for the renderer at `index`.
std::map<Verdict, std::size_t> count_verdicts(const Results& results, std::size_t index);

}  // namespace edgecase
