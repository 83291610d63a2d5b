// SPDX-License-Identifier: MIT
//
// edgecase merge: the results of a run's shards become those of the whole run.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "run/judging.h"
#include "run/merge.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/output/delivery.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

struct MergeCommand {
  std::vector<std::string> paths;
  ReportFiles files;
  std::vector<std::string> timings;
  std::vector<std::string> known;
  std::string color = "auto";
  bool partial = false;
  bool strict = false;
};

// The folder from which ids are counted: what is left of a case's file without its id. `cases`
// where there is no case.
std::filesystem::path suite_folder_of(const Results& results) {
  for (const CaseResults& one : results.cases) {
    const std::string tail = "/" + one.id.substr(0, one.id.find(':')) + ".json";
    if (one.file.ends_with(tail)) return one.file.substr(0, one.file.size() - tail.size());
    if (one.file == tail.substr(1)) return ".";
  }
  return "cases";
}

ExitCode merge(const MergeCommand& command) {
  if (!command.files.are_distinct_from(command.paths)) return ExitCode::usage;
  std::vector<MergePart> parts;
  for (const std::string& path : command.paths) {
    ExitCode exit = ExitCode::as_expected;
    auto results = load_results(path, exit);
    if (!results) return exit;
    parts.push_back({path, std::move(*results)});
  }
  auto merged = merge_results(std::move(parts), command.partial);
  if (const auto* fault = std::get_if<std::string>(&merged)) {
    print_error(*fault);
    return ExitCode::usage;
  }
  Results& results = std::get<Results>(merged);
  const auto known = load_known_faults(suite_folder_of(results) / kKnownFolder, command.known);
  if (!known) return ExitCode::usage;
  conclude(results, {*known, command.strict});
  print_diagnostics(results.diagnostics);
  ExitCode exit = ExitCode::as_expected;
  auto durations = load_durations(command.timings, exit);
  if (!durations) return exit;
  ReportFiles files = command.files;
  files.durations = std::move(*durations);
  return deliver_results(results, files, command.color);
}

}  // namespace

void add_merge_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "merge", "Join the results of a run's shards: judge them as one run, write reports");
  auto options = std::make_shared<MergeCommand>();
  command->add_option("results", options->paths, "Results files of `edgecase run`, of all shards")
      ->required();
  options->files.add_to(*command, "-o,--json");
  add_timings_option(*command, options->timings);
  add_known_option(*command, options->known);
  add_strict_option(*command, options->strict);
  command->add_flag("--partial", options->partial,
                    "Merge although shards are missing; the results count as interrupted");
  command->add_option("--color", options->color, "Colours in the summary")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  command->callback([options, &exit] { exit = merge(*options); });
}

}  // namespace edgecase
