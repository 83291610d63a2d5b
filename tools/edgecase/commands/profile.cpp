// SPDX-License-Identifier: MIT
//
// edgecase profile: which rules a renderer follows, measured.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "profile/profile.h"
#include "reports/text.h"
#include "run/renderers.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/progress_line.h"
#include "tools/edgecase/project.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

constexpr std::size_t kOfEachRule = 16;

struct ProfileCommand {
  SelectionOptions selection;
  std::string renderer;
  ProjectOption project;
  PolicyOptions policy;
  double timeout = 10;
  int jobs = 0;
  std::string progress = "auto";
  bool full = false;
  std::string json;
  std::string policy_file;
};

MeasureOptions options_of(const ProfileCommand& command) {
  MeasureOptions options;
  options.name = command.renderer;
  options.jobs =
      command.jobs > 0 ? command.jobs : static_cast<int>(std::thread::hardware_concurrency());
  options.stop = &interrupted();
  return options;
}

// Writes to a file, or to standard output for "-".
bool deliver(const std::string& path, const std::string& text) {
  if (path != "-") return write_file(path, text);
  fmt::print("{}", text);
  return true;
}

// The summary comes last, where users read it. Its tenth line names the options for more.
void print_profile(const ProfileCommand& command, const Profile& profile) {
  if (command.full) fmt::print("{}\n", xml_text(profile_tables(profile)));
  fmt::print("{}{}", xml_text(profile_summary(profile)),
             command.full ? ""
                          : "--full prints the tables, --policy-file FILE writes the policy that "
                            "was found\n");
}

ExitCode deliver_all(const ProfileCommand& command, const Profile& profile) {
  if (command.json != "-" && command.policy_file != "-") print_profile(command, profile);
  ExitCode exit = ExitCode::as_expected;
  if (!command.json.empty() && !deliver(command.json, profile_json(profile, kToolName)))
    exit = ExitCode::internal;
  if (!command.policy_file.empty() && !deliver(command.policy_file, policy_text(profile)))
    exit = ExitCode::internal;
  if (std::ranges::all_of(profile.surfaces, [](const auto& one) { return one.drawn == 0; }))
    exit = worse(exit, ExitCode::renderer);
  return exit;
}

ExitCode run_profile(const ProfileCommand& command) {
  const Selection selection = command.selection.selection();
  const auto policy = command.policy.load(selection);
  if (!policy || !are_known({command.renderer})) return ExitCode::usage;
  const Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  if (!suite.diagnostics.empty()) return ExitCode::usage;
  if (suite.cases.empty()) {
    print_nothing_selected();
    return ExitCode::nothing_selected;
  }
  const RendererOptions renderer{
      *policy, std::chrono::milliseconds(static_cast<int>(command.timeout * 1000)),
      worker_directory(), &interrupted(), command.project.folders};
  MeasureOptions options = options_of(command);
  ProgressLine progress(command.progress, "cases");
  options.progress = [&](std::size_t done, std::size_t total) { progress.update(done, total); };
  const InterruptGuard guard;
  try {
    const Profile profile = measure(
        is_whole_suite(selection) ? cases_that_tell(suite.cases, kOfEachRule) : suite.cases,
        [&] {
          return std::get<std::unique_ptr<Renderer>>(make_renderer(command.renderer, renderer));
        },
        options);
    progress.clear();
    return deliver_all(command, profile);
  } catch (const MeasurementStopped&) {
    progress.clear();
    print_error("interrupted; a part of the cases makes no profile, so nothing was written");
    return ExitCode::unexpected;
  }
}

}  // namespace

void add_profile_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command =
      app.add_subcommand("profile", "Measure which alternative of each rule a renderer follows");
  auto options = std::make_shared<ProfileCommand>();
  options->selection.add_to(*command, false);
  command->add_option("--against", options->renderer, "Renderer to measure, as `run` names them")
      ->required();
  options->policy.add_to(*command);
  command->add_flag("--full", options->full, "Print the table of each surface before the summary");
  command->add_option("--json", options->json, "Write everything as JSON; - for standard output");
  command->add_option(
      "--policy-file", options->policy_file,
      "File for the measured policy, which --policy accepts; - for standard output");
  command->add_option("--timeout", options->timeout, "Seconds per case")
      ->check(in_range(0.01, 3600.0));
  command->add_option("--jobs", options->jobs, "Threads (default: one per processor)")
      ->check(in_range(1, 256));
  command->add_option("--progress", options->progress, "Progress on standard error")
      ->check(CLI::IsMember({"auto", "never"}));
  options->project.add_to(*command);
  command->callback([options, command, &exit] {
    options->project.take(*command, options->renderer, {"--policy"});
    exit = run_profile(*options);
  });
}

}  // namespace edgecase
