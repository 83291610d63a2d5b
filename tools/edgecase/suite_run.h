// SPDX-License-Identifier: MIT
//
// What `run` and `explain --against` share: rendering a suite against renderers, with progress on
// standard error and Ctrl-C that keeps what was finished.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/expectations.h"
#include "results/results.h"
#include "run/run_difference.h"
#include "run/selection.h"
#include "tools/edgecase/exit_code.h"
#include "tools/edgecase/options.h"

namespace edgecase {

struct SuiteRunOptions {
  std::vector<std::string> renderers;  // none: the default one
  int jobs = 0;                        // 0: one per processor
  double timeout = 10;                 // seconds per case
  std::string progress = "auto";

  void add_to(CLI::App& command);
  // The renderers, or the default one where none is given.
  std::vector<std::string> named() const;
};

// The renderer that is used where none is named: OSMesa's llvmpipe, or EGL's where there is no
// OSMesa.
std::string default_renderer();

// Are all of them names of renderers, each given once? Prints an error otherwise.
bool are_known(const std::vector<std::string>& renderers);

// Runs the suite. Prints an error and returns nothing when a renderer's name is unknown or given
// twice.
std::optional<Results> run_against(const Suite& suite, const Policy& policy,
                                   const std::map<std::string, Policy>& profiles,
                                   SuiteRunOptions options);

// What `run` does beyond drawing: expectations, and what hangs on them.
struct ExpectantRun {
  std::vector<Expectations> expectations;
  std::size_t max_unexpected = 0;    // RunOptions has it
  bool reruns = true;                // ask for unexpected answers again (run/rerun.h)
  bool whole_suite = false;          // as Results have it
  bool strict = false;               // what is contested is unexpected, too
  std::optional<MergePart> earlier;  // a run to go on with (run/resume.h)
};

// The same, with the expectations applied. Says on standard error where not all unexpected answers
// were asked for again, and of an earlier run how much was taken over; one that is not the same in
// policy, renderers or selection is an error, printed.
std::optional<Results> run_expecting(const Suite& suite, const Policy& policy,
                                     const std::map<std::string, Policy>& profiles,
                                     SuiteRunOptions options, ExpectantRun expectant);

// The expectations of these renderers, read from `folder` or from the files named; a file that is
// missing in the folder is no error, and one of another renderer is not read. Nothing, with the
// error printed, when one is broken.
std::optional<std::vector<Expectations>> load_expectations(
    const std::filesystem::path& folder, const std::vector<std::string>& files,
    const std::vector<std::string>& renderers);

// Applies the expectations to the renderers that they belong to, and finds their missing cases.
// `strict`: what is contested is unexpected, too.
void apply_all_expectations(const std::vector<Expectations>& expectations, bool strict,
                            Results& results);

// The exit code that results deserve, expectations having been applied.
ExitCode exit_code_of(const Results& results);

}  // namespace edgecase
