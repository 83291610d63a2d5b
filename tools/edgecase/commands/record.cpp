// SPDX-License-Identifier: MIT
//
// edgecase record: writes a renderer's answers to a file, which recording:FILE replays.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "model/renderer.h"
#include "reports/text.h"
#include "run/record.h"
#include "run/renderers.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/output/distinct_files.h"
#include "tools/edgecase/output/progress_line.h"
#include "tools/edgecase/project.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

struct RecordCommand {
  SelectionOptions selection;
  std::string renderer;
  ProjectOption project;
  std::string file;
  int jobs = 0;
  double timeout = 10;
  std::string progress = "auto";
};

Recorded record_with_progress(const RecordCommand& command, const Suite& suite,
                              const Policy& policy) {
  ProgressLine progress(command.progress, "cases");
  RecordOptions options;
  options.tool = kToolName;
  options.renderer = command.renderer;
  options.renderer_options = {policy,
                              std::chrono::milliseconds(static_cast<int>(command.timeout * 1000)),
                              worker_directory(), &interrupted(), command.project.folders};
  options.jobs =
      command.jobs > 0 ? command.jobs : static_cast<int>(std::thread::hardware_concurrency());
  options.progress = [&](std::size_t done, std::size_t total) { progress.update(done, total); };
  options.stop = &interrupted();
  const InterruptGuard guard;
  return record_suite(suite, options);
}

void print_recorded(const RecordCommand& command, const Recorded& recorded) {
  const RendererInfo& info = recorded.renderer;
  fmt::print("{}: {} case{} of {} ({}, {}), {} without a rendering; {} bytes{}\n", command.file,
             recorded.cases, recorded.cases == 1 ? "" : "s", one_line(known_as(info)),
             one_line(info.device), one_line(info.version), recorded.failures,
             recorded.bytes.size(), recorded.is_complete ? "" : "; incomplete");
}

ExitCode record(const RecordCommand& command) {
  if (!are_known({command.renderer})) return ExitCode::usage;
  const Selection selection = command.selection.selection();
  if (!are_distinct({{"--output", command.file}}, selection.paths)) return ExitCode::usage;
  const Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  ExitCode exit = suite.diagnostics.empty() ? ExitCode::as_expected : ExitCode::usage;
  if (suite.cases.empty()) {
    if (!suite.diagnostics.empty()) return exit;
    print_nothing_selected();
    return ExitCode::nothing_selected;
  }
  const Recorded recorded = record_with_progress(command, suite, Policy());
  if (!recorded.unavailable.empty()) {
    print_error(fmt::format("{} could not be asked: {}; nothing was written", command.renderer,
                            recorded.unavailable));
    return worse(exit, ExitCode::renderer);
  }
  if (recorded.cases == 0) {
    print_error("no case was answered; nothing was written");
    return worse(exit, recorded.is_complete ? ExitCode::renderer : ExitCode::unexpected);
  }
  if (!write_file(command.file, recorded.bytes)) return worse(exit, ExitCode::internal);
  print_recorded(command, recorded);
  if (recorded.is_complete) return exit;
  print_error("interrupted; the recording has the cases that were finished");
  return worse(exit, ExitCode::unexpected);
}

}  // namespace

void add_record_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "record", "Write a renderer's answers to a file, which recording:FILE replays anywhere");
  auto options = std::make_shared<RecordCommand>();
  options->selection.add_to(*command, true);
  command->add_option("--against", options->renderer, "Renderer to record, as `run` names them")
      ->required();
  command->add_option("-o,--output", options->file, "The recording to write")->required();
  command->add_option("--jobs", options->jobs, "Threads (default: one per processor)")
      ->check(in_range(1, 256));
  command->add_option("--timeout", options->timeout, "Seconds per case")
      ->check(in_range(0.01, 3600.0));
  command->add_option("--progress", options->progress, "Progress on standard error")
      ->check(CLI::IsMember({"auto", "never"}));
  options->project.add_to(*command);
  command->callback([options, command, &exit] {
    options->project.take(*command, options->renderer, {"paths"});
    exit = record(*options);
  });
}

}  // namespace edgecase
