// SPDX-License-Identifier: MIT
//
// Asking again: an unexpected answer may be a renderer's that does not always answer alike.
//
// Each unexpected answer of a run is asked for once more, of a process that is new to the run. If
// the second one has another verdict or fingerprint, judged as the run is read, the result keeps
// both and is a flake. A second answer that is the same leaves no trace.
#pragma once

#include <cstddef>

#include "results/results.h"
#include "run/run.h"
#include "suite/selection.h"

namespace edgecase {

// For --last-failed, the cases of earlier results to run once more: those of which any renderer's
// result is not as expected or whose hand-drawn truth is not met, and the files that could not be
// loaded, whose cases nobody knows.
NamedCases unexpected_cases(const Results& results);

// At most so many answers are asked for again, of all renderers together; and of those that did not
// come in time, each of which may cost its time once more, so many.
constexpr std::size_t kMostReruns = 1000;
constexpr std::size_t kMostTimeoutReruns = 10;

struct RerunCounts {
  std::size_t asked = 0;
  std::size_t not_asked = 0;  // unexpected answers beyond the limits
  bool stopped = false;       // by options.stop, before all were asked
};

// `results` are those of the suite under the same options, judged, known faults applied. Standings
// stay as they are: the caller applies known faults again.
RerunCounts rerun_unexpected(const Suite& suite, const RunOptions& options, Results& results);

}  // namespace edgecase
