// SPDX-License-Identifier: MIT
//
// Results of earlier runs that a run takes something over from. A file that the user names on the
// command line is believed. One that merely lies where the run is to write is believed only if a
// run of this user wrote it (results_key.h), and never in CI: a checkout may hold any file.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "results/results.h"
#include "run/merge.h"
#include "tools/edgecase/exit_code.h"
#include "tools/edgecase/results_key.h"

namespace edgecase {

// The user's key, or why there is none.
struct UserKey {
  std::variant<ResultsKey, std::string> made = ResultsKey::of_user();

  const ResultsKey* get() const { return std::get_if<ResultsKey>(&made); }
};

// Results that nobody named.
struct FoundResults {
  std::optional<Results> results;  // that may be believed
  std::string doubt;               // why those that are there may not: "CI is set"; or empty
};

// The results at `path`, whole or cut off, if a run of this user wrote them.
FoundResults own_results(const std::string& path, const UserKey& key);

// A run that ended early.
struct EarlierRun {
  std::optional<MergePart> run;  // nothing: nothing was finished
  bool is_own = false;           // a run of this user wrote it, and it took over nothing else
};

// What is finished of the run into the file `path`, by its journal (journal.h) or else by the file
// itself. `is_named`: the user named that file; otherwise it has to be the user's own. Returns the
// exit code, with the error printed, where it cannot be had.
std::variant<EarlierRun, ExitCode> run_to_resume(const std::string& path, bool is_named,
                                                 const UserKey& key);

}  // namespace edgecase
