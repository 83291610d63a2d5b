// SPDX-License-Identifier: MIT
//
// Results: everything that one run found, in memory. results/results_json.h writes it; reports draw
// it. Nothing here is computed: src/diff fills verdicts, results/known_faults.h what is known.
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
#include "model/storage.h"
#include "results/case_list.h"

namespace edgecase {

// "opengl" or "none", as policy files say it.
constexpr const char* name_of(Latitude latitude) {
  return latitude == Latitude::none ? "none" : "opengl";
}

// Which share of a run's cases results hold.
struct ShareOfRun {
  int index = 0;  // 0 to count - 1
  int count = 1;
  std::size_t cases = 0;  // of the run as a whole
  std::string selection;  // digest of their ids and of their files' texts
  friend bool operator==(const ShareOfRun&, const ShareOfRun&) = default;
};

// How a known fault stands to what its file says of the release (KnownFault::cases_on).
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

// What a run shows of one known fault of a renderer's driver.
struct FaultSeen {
  std::string renderer;  // name
  std::string id;
  std::string reason;
  std::string link;                   // or empty
  std::size_t cases = 0;              // of the results, for which it accounts at least in part
  std::optional<std::size_t> before;  // the file's count of this release, where it has one
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
  bool interrupted = false;             // not all that was asked for was done
  std::size_t left_out = 0;             // cases that are missing therefore
  // All files of the suite's folder were asked for, and no case of theirs left out on purpose.
  bool whole_suite = false;
  std::optional<ShareOfRun> shard;  // of a run that was divided among several
  // By renderer, then in the order of its driver's file. Where results are not whole, only those
  // that were seen, and none is grown, shrunk or fixed.
  std::vector<FaultSeen> faults;
};

// Do the results hold every case that the suite has?
inline bool is_whole(const Results& results) {
  return results.whole_suite && !results.shard && !results.interrupted &&
         results.diagnostics.empty();
}

// Answers that are not as expected, flakes included: of all renderers, or of the one at `renderer`.
std::size_t count_unexpected(const Results& results);
std::size_t count_unexpected(const Results& results, std::size_t renderer);

// verdict -> number of cases, for the renderer at `index`.
std::map<Verdict, std::size_t> count_verdicts(const Results& results, std::size_t index);

}  // namespace edgecase
