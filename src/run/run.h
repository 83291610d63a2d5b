// SPDX-License-Identifier: MIT
//
// A run: every case of a suite, rendered exactly and by each renderer, compared and judged.
//
// Work is cut into (renderer, slice of the cases) and handed to a few threads. Each has renderers
// of its own and drives them over slice after slice, while the exact rendering of a case is made
// once, by whoever needs it first. Results go to places fixed beforehand, so neither the number of
// threads nor their order can be seen in them. A run that ends after some unexpected cases is the
// exception: with several threads, which cases were finished by then is a matter of chance.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "results/durations.h"
#include "results/known_faults.h"
#include "results/results.h"
#include "run/profiles.h"
#include "run/renderers.h"
#include "suite/selection.h"

namespace edgecase {

// Takes what a run finds while it goes on. One call at a time, from any thread.
class FinishedCases {
 public:
  virtual ~FinishedCases() = default;
  // Before all others, where the run goes on with an earlier one: what of that is kept.
  virtual void hold(const Results& earlier) = 0;
  // What is known of the run, without its cases: before the first one, and again whenever a
  // renderer has said what it is.
  virtual void begin(const Results& run) = 0;
  // A case that all renderers have answered. Where the run decides on its verdict (depends_on_run),
  // it is not judged yet.
  virtual void add(const CaseResults& one) = 0;
};

// All that decides on a run besides its suite. The command line fills it
// (tools/edgecase/suite_run.h).
struct RunOptions {
  Policy policy;
  std::vector<std::string> renderers;  // names that make_renderer knows
  Profiles profiles;                   // of some of them
  RendererOptions renderer_options;
  bool invariance = false;        // the images of all cases are drawn, too
  bool suggested_images = false;  // and those of which the specification only suggests how
  // What comparing one answer may take; beyond that it is not run (timed-out).
  std::chrono::milliseconds comparison_patience{60'000};
  int jobs = 1;                                            // threads, at least 1
  std::function<void(std::size_t, std::size_t)> progress;  // done, total; from any thread; or empty
  // Becomes true when the run should end; put it into renderer_options as well, or a renderer that
  // hangs is waited for.
  const std::atomic<bool>* stop = nullptr;
  // End when so many cases are unexpected however the run is read (run/judging.h), by
  // `known`; the cases that some renderer has answered by then are finished. 0: never.
  std::size_t max_unexpected = 0;
  std::vector<KnownFaults> known;
  bool strict = false;       // what is contested is unexpected, too
  bool reruns = true;        // unexpected answers are asked for again (run/rerun.h)
  bool whole_suite = false;  // as Results have it
  // Look for a difference's causes among what the renderer's profile has before all others: the
  // same results, sooner.
  bool likely_first = true;
  // Results of an earlier run: what they say of answers that are, to the bit, the same, under the
  // same rules, is not found once more (run/earlier_answers.h). The same results, sooner. Null:
  // none. Must live as long as the run, and is not used where max_unexpected is set.
  const Results* earlier = nullptr;
  FinishedCases* finished = nullptr;  // told of each case, where it is set
};

struct CompletedRun {
  Results results;
  Durations durations;   // of all answers
  std::size_t kept = 0;  // answers of which RunOptions::earlier said what they are
};

// Runs and judges. Renderer names must be known. Cases that were left out when the run ended early
// are not in the results, which count them. Known faults are not applied.
CompletedRun run_suite(const Suite& suite, const RunOptions& options);

}  // namespace edgecase
