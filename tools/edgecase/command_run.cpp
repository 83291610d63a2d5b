// SPDX-License-Identifier: MIT
//
// edgecase run: the suite against renderers, judged, held against expectations, reported.
#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <memory>

#include "reports/summary.h"
#include "tools/edgecase/commands.h"
#include "tools/edgecase/report_files.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

struct RunCommand {
  SelectionOptions selection;
  PolicyOptions policy;
  SuiteRunOptions run;
  ReportFiles files;
  std::vector<std::string> expectations;
  std::string color = "auto";
  bool list = false;
};

ExitCode print_list(const Suite& suite) {
  for (const Case& one : suite.cases) fmt::print("{}\n", one.id);
  if (!suite.diagnostics.empty()) return ExitCode::usage;
  if (!suite.cases.empty()) return ExitCode::as_expected;
  print_nothing_selected();
  return ExitCode::nothing_selected;
}

ExitCode run(const RunCommand& command) {
  const Selection selection = command.selection.selection();
  const auto policy = command.policy.load(selection, command.run.renderers);
  if (!policy) return ExitCode::usage;
  const auto expectations =
      load_expectations(suite_folder(selection) / "expectations", command.expectations);
  if (!expectations) return ExitCode::usage;

  const Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  if (command.list) return print_list(suite);
  const auto profiles = load_profiles(selection, command.run.named());
  if (!profiles) return ExitCode::usage;
  auto results = run_against(suite, *policy, *profiles, command.run);
  if (!results) return ExitCode::usage;
  apply_all_expectations(*expectations, *results);

  const bool to_stdout =
      command.files.json == "-" || command.files.junit == "-" || command.files.html == "-";
  write_summary(*results, use_color(command.color, to_stdout ? STDERR_FILENO : STDOUT_FILENO),
                to_stdout ? std::cerr : std::cout);
  ExitCode exit = exit_code_of(*results);
  if (exit == ExitCode::nothing_selected) {
    // Nothing was run: what an earlier run wrote stays.
    print_nothing_selected();
    return exit;
  }
  if (!command.files.write(*results)) return worse(exit, ExitCode::internal);
  const std::string html = command.files.html_path();
  if (!to_stdout && !html.empty()) fmt::print("Report: {}\n", html);
  return exit;
}

}  // namespace

void add_run_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "run", "Compare renderers with the exact side, judge every difference, write reports");
  auto options = std::make_shared<RunCommand>();
  options->selection.add_to(*command, true);
  options->policy.add_to(*command);
  options->run.add_to(*command);
  options->files.add_to(*command);
  add_repeatable(*command, "--expectations", options->expectations,
                 "Expectations file, repeatable (default: those in the suite's folder "
                 "expectations)");
  command->add_option("--color", options->color, "Colours in the summary")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  command->add_flag("--list", options->list, "Only list the ids of the selected cases");
  command->callback([options, &exit] { exit = run(*options); });
}

}  // namespace edgecase
