// SPDX-License-Identifier: MIT
//
// edgecase bench: the speed of exact relative to real renderers, and the time of a run by stage.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <variant>

#include "tools/edgecase/bench/comparison.h"
#include "tools/edgecase/bench/rates.h"
#include "tools/edgecase/bench/report.h"
#include "tools/edgecase/bench/scenes.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

const std::vector<std::string> kParts = {"scenes", "pipeline", "diff", "stages"};

struct BenchCommand {
  BenchPlan plan;
  std::vector<std::string> parts;  // none: all
  SelectionOptions selection;      // of the cases whose stages are timed
  std::string json;
  std::string other;  // a file of another bench
};

// The named cases, or else those of the generated sweep.
Suite suite_of(const BenchCommand& command) {
  Suite suite;
  if (!command.selection.paths.empty()) return load_suite(command.selection.selection());
  suite.cases = bench_cases(command.plan.cases);
  return suite;
}

// The figures of both, or none without such a file. Prints an error where it is none.
std::optional<std::vector<ComparedFigure>> held_against(const std::string& file,
                                                        const BenchReport& report) {
  if (file.empty()) return std::vector<ComparedFigure>();
  const auto text = read_file(file);
  if (!text) return std::nullopt;
  auto compared = compare_benches(bench_json(report), *text);
  if (const auto* message = std::get_if<std::string>(&compared)) {
    print_error(fmt::format("{}: {}; name one", file, *message));
    return std::nullopt;
  }
  return std::get<std::vector<ComparedFigure>>(std::move(compared));
}

ExitCode bench(BenchCommand command) {
  BenchPlan& plan = command.plan;
  if (plan.renderers.empty()) plan.renderers = {"egl:llvmpipe"};
  if (!are_known(plan.renderers)) return ExitCode::usage;
  // A wrong file is told before anything is measured.
  if (!held_against(command.other, {})) return ExitCode::usage;
  const auto is_asked = [&](const char* part) {
    return command.parts.empty() || std::ranges::find(command.parts, part) != command.parts.end();
  };
  BenchReport report;
  report.rounds = plan.rounds;
  if (is_asked("scenes")) report.scenes = time_scenes(plan);
  if (is_asked("pipeline")) report.pipelines = time_pipelines(plan);
  if (is_asked("diff")) report.diff = time_diff(plan);
  if (is_asked("stages")) {
    Suite suite;
    const double seconds = time_of(0, [&] { suite = suite_of(command); });
    print_diagnostics(suite.diagnostics);
    if (!suite.diagnostics.empty()) return ExitCode::usage;
    if (suite.cases.empty()) return ExitCode::nothing_selected;
    report.stages = time_stages(plan, suite, seconds);
  }
  const auto compared = held_against(command.other, report);
  if (!compared) return ExitCode::usage;
  if (command.json != "-") print_bench(report);
  if (command.json != "-" && !command.other.empty()) print_comparison(*compared);
  if (command.json == "-")
    fmt::print("{}", bench_json(report));
  else if (!command.json.empty() && !write_file(command.json, bench_json(report)))
    return ExitCode::internal;
  return ExitCode::as_expected;
}

}  // namespace

void add_bench_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command =
      app.add_subcommand("bench", "Time exact and renderers side by side, and the stages of a run");
  auto options = std::make_shared<BenchCommand>();
  BenchPlan& plan = options->plan;
  options->selection.add_to(*command, true);
  add_repeatable(*command, "--against", plan.renderers,
                 "OpenGL renderer, as `run` names them; repeatable (default: egl:llvmpipe)");
  add_repeatable(*command, "--part", options->parts,
                 "Only scenes, pipeline, diff or stages; repeatable (default: all)");
  command->get_option("--part")->check(CLI::IsMember(kParts));
  command->add_option("--rounds", plan.rounds, "Rounds of each measurement")
      ->check(in_range(1, 1000))
      ->capture_default_str();
  command->add_option("--seconds", plan.seconds, "Least seconds of one measurement")
      ->check(in_range(0.0, 600.0))
      ->capture_default_str();
  command->add_option("--side", plan.side, "Side of the scenes' targets, in pixels")
      ->check(CLI::IsMember({64, 128, 256, 512, 1024}))
      ->capture_default_str();
  command->add_option("--cases", plan.cases, "Approximate number of cases of the pipeline")
      ->check(in_range(64, 1'000'000))
      ->capture_default_str();
  command->add_option("--json", options->json,
                      "Write all measurements as JSON; - for standard output");
  command->add_option("--compare", options->other,
                      "File of an earlier --json: print every figure that both have, and the ratio "
                      "of here to there");
  command->callback([options, &exit] { exit = bench(*options); });
}

}  // namespace edgecase
