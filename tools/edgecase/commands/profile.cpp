// SPDX-License-Identifier: MIT
//
// edgecase profile: which rules a renderer follows, measured.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "profile/asked_scenes.h"
#include "profile/profile.h"
#include "reports/text.h"
#include "run/record.h"
#include "run/renderers.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/output/progress_line.h"
#include "tools/edgecase/project.h"
#include "tools/edgecase/suite_run.h"

namespace edgecase {
namespace {

struct ProfileCommand {
  std::string renderer;
  ProjectOption project;
  std::uint64_t seed = 1;
  std::size_t scenes = 0;  // 0: few, and those that tell alternatives apart
  bool thorough = false;
  bool asks_otherwise = false;  // than by default
  std::vector<std::string> surfaces;
  PolicyOptions policy;
  double timeout = 10;
  int jobs = 0;
  std::string progress = "auto";
  bool full = false;
  std::size_t clusters = 12;
  std::string json;
  std::string policy_file;
};

MeasureOptions options_of(const ProfileCommand& command) {
  MeasureOptions options;
  if (is_recording(command.renderer)) options = options_of_pages();
  options.name = command.renderer;
  options.seed = command.seed;
  if (command.thorough) options.scenes_per_kind = options.searched_scenes;
  if (command.scenes > 0) options.scenes_per_kind = options.searched_scenes = command.scenes;
  options.jobs =
      command.jobs > 0 ? command.jobs : static_cast<int>(std::thread::hardware_concurrency());
  options.stop = &interrupted();
  if (command.surfaces.empty()) return options;
  options.surfaces.clear();
  for (const std::string& name : command.surfaces) {
    Surface surface = Surface::fbo;
    parse_name(name, surface);
    options.surfaces.push_back(surface);
  }
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
  if (command.full) fmt::print("{}\n", xml_text(profile_text(profile, command.clusters)));
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
  for (const SurfaceProfile& surface : profile.surfaces)
    if (!surface.unavailable.empty()) {
      if (is_recording(command.renderer))
        print_error(
            "a profile needs a recording of its own scenes: `edgecase web --probes -o "
            "page.html` makes a page that asks them");
      exit = worse(exit, ExitCode::renderer);
    }
  return exit;
}

ExitCode run_profile(const ProfileCommand& command) {
  Selection suite;
  suite.paths = {default_suite()};
  const auto policy = command.policy.load(suite);
  if (!policy || !are_known({command.renderer})) return ExitCode::usage;
  if (is_recording(command.renderer) && command.asks_otherwise) {
    print_error(
        "a recording answers what its page asked; leave out --seed, --scenes, --thorough and "
        "--surface, or measure the renderer itself");
    return ExitCode::usage;
  }
  const RendererOptions renderer{
      *policy, std::chrono::milliseconds(static_cast<int>(command.timeout * 1000)),
      worker_directory(), &interrupted(), command.project.folders};
  MeasureOptions options = options_of(command);
  ProgressLine progress(command.progress, "scenes");
  options.progress = [&](std::size_t done, std::size_t total) { progress.update(done, total); };
  const InterruptGuard guard;
  try {
    const Profile profile = measure(
        [&] {
          return std::get<std::unique_ptr<Renderer>>(make_renderer(command.renderer, renderer));
        },
        options);
    progress.clear();
    return deliver_all(command, profile);
  } catch (const MeasurementStopped&) {
    progress.clear();
    print_error("interrupted; a part of the scenes makes no profile, so nothing was written");
    return ExitCode::unexpected;
  }
}

}  // namespace

void add_profile_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command =
      app.add_subcommand("profile", "Measure which alternative of each rule a renderer follows");
  auto options = std::make_shared<ProfileCommand>();
  command->add_option("--against", options->renderer, "Renderer to measure, as `run` names them")
      ->required();
  command->add_option("--seed", options->seed, "Number that fixes the random scenes")
      ->capture_default_str();
  CLI::Option* scenes = command->add_option(
      "--scenes", options->scenes,
      "Random scenes of each primitive type on each surface (default: 100, and of 20000 those that "
      "tell alternatives apart)");
  scenes->check(in_range(100, 10'000'000));
  command->add_flag("--thorough", options->thorough, "The same as --scenes 20000")
      ->excludes(scenes);
  add_repeatable(*command, "--surface", options->surfaces,
                 "fbo or window; repeatable (default: both)");
  command->get_option("--surface")->check(CLI::IsMember({"fbo", "window"}));
  options->policy.add_to(*command);
  CLI::Option* full = command->add_flag("--full", options->full,
                                        "Print the tables of each surface before the summary");
  command
      ->add_option("--clusters", options->clusters,
                   "Most clusters of counter-examples to print for each surface")
      ->needs(full)
      ->capture_default_str();
  command->add_option("--json", options->json, "Write everything as JSON; - for standard output");
  command->add_option(
      "--policy-file", options->policy_file,
      "File for the measured policy, which --policy accepts; - for standard output");
  command->add_option("--timeout", options->timeout, "Seconds per scene")
      ->check(in_range(0.01, 3600.0));
  command->add_option("--jobs", options->jobs, "Threads (default: one per processor)")
      ->check(in_range(1, 256));
  command->add_option("--progress", options->progress, "Progress on standard error")
      ->check(CLI::IsMember({"auto", "never"}));
  options->project.add_to(*command);
  command->callback([options, command, &exit] {
    options->project.take(*command, options->renderer, {"--policy"});
    for (const char* name : {"--seed", "--scenes", "--thorough", "--surface"})
      options->asks_otherwise |= command->get_option(name)->count() > 0;
    exit = run_profile(*options);
  });
}

}  // namespace edgecase
