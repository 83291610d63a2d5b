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

namespace edgecase {

// "opengl" or "none", as policy files say it.
constexpr const char* name_of(Latitude latitude) {
  return latitude == Latitude::none ? "none" : "opengl";
}

// What judging makes of an answer. Two answers that are equal in this show the same.
struct Judgement {
  Verdict verdict = Verdict::agree;
  std::string fingerprint;
  friend bool operator==(const Judgement&, const Judgement&) = default;
};

inline Judgement judgement_of(const Result& result) {
  return {result.verdict, result.fingerprint};
}

// A result, and what is known of the renderer's other answers to the case.
struct KnownResult : Result {
  std::vector<std::string> faults;  // ids of the known faults that account for something in it
  // Of an unexpected answer that was asked for a second time, what came then, where it was another.
  std::optional<Judgement> again;

  KnownResult() = default;
  KnownResult(Result result) : Result(std::move(result)) {}
};

// One case with the results of all renderers, in the order of Results::renderers.
struct CaseResults {
  std::string id;
  std::string title;
  std::string why;
  std::vector<std::string> rules;
  std::string spec;
  std::string origin;
  std::vector<std::string> tags;
  std::string file;         // path of the case file, as given
  SharedText source;        // its text
  std::string file_digest;  // of its text (model/text.h)
  std::string surface;
  int width = 0;
  int height = 0;
  std::optional<Viewport> viewport;          // where it is not the target's rectangle
  Shared<PackedWords> pixels;                // of the exact side, RGBA8, bottom row first
  SampleImage samples;                       // of the exact side, where it is multisampled
  std::size_t fragments = 0;                 // of the exact side
  Figure figure;                             // the case's primitives and vertices
  std::vector<std::string> expect_failures;  // hand-drawn truths that exact does not meet
  std::vector<KnownResult> results;
};

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
  std::vector<CaseResults> cases;       // sorted by id
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

// verdict -> number of cases, for the renderer at `index`.
std::map<Verdict, std::size_t> count_verdicts(const Results& results, std::size_t index);

}  // namespace edgecase
