// SPDX-License-Identifier: MIT
//
// edgecase-gtest: the cases of `edgecase run` as a GoogleTest program, for tools that list, filter,
// shard and run such programs: deqp-runner, ctest, Bazel, IDEs. GoogleTest takes its own options;
// the others select cases and renderers as in `run`.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "tools/edgecase/help/usage_errors.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/program.h"
#include "tools/edgecase_gtest/case_tests.h"
#include "tools/edgecase_gtest/test_names.h"

namespace edgecase {
namespace {

struct GtestCommand {
  SelectionOptions selection;
  PolicyOptions policy;
  SuiteRunOptions run;
  std::vector<std::string> known;
  bool strict = false;

  void add_to(CLI::App& app) {
    // GoogleTest divides tests into shards by its own variables, which Bazel sets.
    selection.add_to(app, false);
    policy.add_to(app);
    add_strict_option(app, strict);
    run.add_to(app);
    add_known_option(app, known);
    // Some runners of GoogleTest programs pass no arguments, but set variables.
    app.get_option("--against")->envname("EDGECASE_AGAINST");
    app.get_option("--jobs")->envname("EDGECASE_JOBS");
    app.get_option("--trust")->envname("EDGECASE_TRUST");
  }
};

// The tests that the options select, or an exit code if they cannot be loaded.
std::variant<CaseTests, ExitCode> load_tests(const GtestCommand& command) {
  CaseTests tests;
  tests.progress = command.run.progress;
  const std::vector<std::string> renderers = command.run.named();
  Selection selection = command.selection.selection();
  if (!are_known(renderers)) return ExitCode::usage;
  const bool narrowed =
      narrow_to_filter(GTEST_FLAG_GET(filter), suite_prefixes(renderers), selection);
  const auto policy = command.policy.load(selection, renderers);
  if (!policy) return ExitCode::usage;
  tests.suite = load_suite(selection);
  print_diagnostics(tests.suite.diagnostics);
  if (tests.suite.is_misspelt) return ExitCode::usage;
  if (tests.suite.cases.empty() && tests.suite.diagnostics.empty() && !narrowed) {
    print_nothing_selected();
    return ExitCode::nothing_selected;
  }
  auto known = load_known_faults(suite_folder(selection) / kKnownFolder, command.known);
  auto profiles = load_profiles(selection, renderers);
  if (!known || !profiles) return ExitCode::usage;
  tests.run = command.run.options(*policy, *profiles, std::move(*known));
  tests.run.strict = command.strict;
  return tests;
}

ExitCode run(const GtestCommand& command) {
  auto tests = load_tests(command);
  if (const auto* exit = std::get_if<ExitCode>(&tests)) return *exit;
  register_case_tests(std::get<CaseTests>(std::move(tests)));
  return RUN_ALL_TESTS() == 0 ? ExitCode::as_expected : ExitCode::unexpected;
}

}  // namespace
}  // namespace edgecase

int main(int argc, char** argv) {
  using edgecase::ExitCode;
  if (!edgecase::begin_program()) return static_cast<int>(ExitCode::usage);
  testing::InitGoogleTest(&argc, argv);
  CLI::App app{
      "Registers cases as GoogleTest tests: one a case and renderer, which passes, fails with the "
      "explanation, or is skipped where the renderer does not support the scene."};
  app.name("edgecase-gtest");
  app.set_version_flag("--version", edgecase::kToolName);
  edgecase::GtestCommand command;
  command.add_to(app);
  return static_cast<int>(edgecase::run_program(app, argc, argv, [&] {
    command.run.project.runs = !GTEST_FLAG_GET(list_tests);
    command.run.take_project(app);
    return edgecase::run(command);
  }));
}
