// SPDX-License-Identifier: MIT
//
// edgecase report: reports from a results file, without rendering anything.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "results/standing.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/report_files.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

struct ReportCommand {
  std::vector<std::string> results;  // of several releases; the last are reported
  std::string since;                 // results file, or empty
  ReportFiles files;
  std::vector<std::string> timings;
  bool strict = false;
};

ExitCode report(const ReportCommand& command) {
  ExitCode exit = ExitCode::as_expected;
  ReportFiles files = command.files;
  if (!files.are_distinct_from(command.results)) return ExitCode::usage;
  std::optional<Results> results;
  for (const std::string& file : command.results) {
    results.reset();  // one at a time in memory
    results = load_results(file, exit);
    if (!results) return exit;
    if (command.results.size() > 1 && !add_generation_of(file, *results, files.generations))
      return ExitCode::usage;
  }
  if (command.strict) hold_contested(*results);
  auto durations = load_durations(command.timings, exit);
  if (!durations) return exit;
  files.durations = std::move(*durations);
  if (!command.since.empty()) {
    auto before = load_results(command.since, exit);
    if (!before) return exit;
    files.since = changes_since(std::move(*before), *results, exit);
    if (!files.since) return exit;
  }
  if (!files.write(*results)) return ExitCode::internal;
  files.open_if_asked();
  return ExitCode::as_expected;
}

}  // namespace

void add_report_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command =
      app.add_subcommand("report", "Write reports from a results file, without rendering");
  auto options = std::make_shared<ReportCommand>();
  command
      ->add_option("results", options->results,
                   "Results file of `edgecase run`; of several, whole ones of several releases, "
                   "the last is reported, and the HTML report has known faults by release")
      ->required();
  command->add_option("--since", options->since,
                      "Earlier results file; the HTML report shows what has changed since");
  add_strict_option(*command, options->strict);
  options->files.add_to(*command);
  add_timings_option(*command, options->timings);
  command->callback([options, &exit] { exit = report(*options); });
}

}  // namespace edgecase
