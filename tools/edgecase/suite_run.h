// SPDX-License-Identifier: MIT
//
// What `run` and `explain --against` share: rendering a suite against renderers, with progress on
// standard error and Ctrl-C that keeps what was finished.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/known_faults.h"
#include "results/results.h"
#include "run/merge.h"
#include "run/run.h"
#include "suite/selection.h"
#include "tools/edgecase/exit_code.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/project.h"

namespace edgecase {

struct SuiteRunOptions {
  std::vector<std::string> renderers;  // none: the default one
  int jobs = 0;                        // 0: one per processor
  double timeout = 10;                 // seconds per case
  bool invariance = false;             // images of all cases are drawn, too
  std::string progress = "auto";
  ProjectOption project;

  void add_to(CLI::App& command);
  // Gives the command, once it is parsed, what the project's file says and its own options do not
  // (project.h). Where no renderer is named and `asks_all`, all of the project are. Throws
  // ProjectError.
  void take_project(CLI::App& command, bool asks_all = true);
  // The renderers, or the default one where none is given.
  std::vector<std::string> named() const;
  RunOptions options(const Policy& policy, const Profiles& profiles,
                     std::vector<KnownFaults> known = {}) const;
};

// The renderer that is used where none is named.
constexpr const char* kDefaultRenderer = "egl:llvmpipe";

// Are all of them names of renderers, each given once? Prints an error otherwise.
bool are_known(const std::vector<std::string>& renderers);

// Runs the suite. Prints an error and returns nothing when a renderer's name is unknown or given
// twice.
std::optional<Results> run_against(const Suite& suite, const Policy& policy,
                                   const Profiles& profiles, const SuiteRunOptions& options);

// The same, with the known faults applied; `progress` as SuiteRunOptions have it. `begun`: a run to
// go on with (run/merge.h). Says on standard error where not all unexpected answers were asked for
// again, and of a begun run how much was taken over; one that is not the same in policy, renderers
// or selection is an error, printed.
std::optional<CompletedRun> run_judged(const Suite& suite, RunOptions run,
                                       const std::string& progress,
                                       std::optional<MergePart> begun = std::nullopt);

// The known faults in `folder`, which may be missing, or in the files and folders named; those of
// one driver are joined. Beside those of the installed suite, the folder `known` here counts.
// Nothing, with the error printed, when a file is broken or two faults of a driver have one id.
std::optional<std::vector<KnownFaults>> load_known_faults(const std::filesystem::path& folder,
                                                          const std::vector<std::string>& paths);

// The exit code that results deserve, known faults having been applied.
ExitCode exit_code_of(const Results& results);

}  // namespace edgecase
