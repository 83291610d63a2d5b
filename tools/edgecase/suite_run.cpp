// SPDX-License-Identifier: MIT
#include "tools/edgecase/suite_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>
#include <utility>
#include <variant>

#include "casefile/loader.h"
#include "model/renderer.h"
#include "model/text.h"
#include "results/standing.h"
#include "run/judging.h"
#include "run/merge.h"
#include "run/renderers.h"
#include "run/rerun.h"
#include "run/run.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/output/progress_line.h"

namespace edgecase {
namespace {

bool is_known(const std::string& renderer) {
  auto made = make_renderer(renderer, {{}, std::chrono::seconds(1), worker_directory(), {}, {}});
  if (const auto* error = std::get_if<std::string>(&made)) {
    print_error(*error);
    return false;
  }
  return true;
}

ExitCode exit_code_of(const ResultOutline& answer) {
  if (!is_unexpected(answer.standing)) return ExitCode::as_expected;
  if (answer.standing == Standing::flake) return ExitCode::unexpected;
  if (answer.failure) return ExitCode::renderer;
  return ExitCode::unexpected;
}

CompletedRun run_with_progress(const Suite& suite, RunOptions run, const std::string& kind) {
  ProgressLine progress(kind, "cases");
  run.progress = [&](std::size_t done, std::size_t total) { progress.update(done, total); };
  CompletedRun ran = run_suite(suite, run);
  ran.results.tool = kToolName;
  return ran;
}

constexpr const char* kThisRun = "this run";

// The first case of the rest, asked for what the renderers are: nobody should wait for the others
// to learn that they do not belong to the earlier run.
std::optional<RunDifference> difference_at_once(const MergePart& earlier, const Suite& rest,
                                                const RunOptions& run) {
  Suite first;
  if (!rest.cases.empty()) first.cases.push_back(rest.cases[0]);
  MergePart asked{kThisRun, run_suite(first, run).results};
  asked.results.tool = kToolName;
  return difference_of_runs(earlier, asked);
}

// Runs what the begun run does not hold, and merges.
std::variant<CompletedRun, std::string> run_rest(const Suite& suite, RunOptions run,
                                                 const std::string& progress, MergePart begun) {
  FinishedCases* const finished = std::exchange(run.finished, nullptr);
  const std::string name = begun.name;
  auto resumed = resume(suite, std::move(begun));
  if (auto* fault = std::get_if<std::string>(&resumed)) return std::move(*fault);
  auto& [held, rest] = std::get<Resumption>(resumed);
  MergePart first{name, std::move(held)};
  if (const auto found = difference_at_once(first, rest, run))
    return found->what + "; run as then, or without --resume";
  print_error(fmt::format("{} of {} {} taken over from {}", first.results.cases.size(),
                          counted(suite.cases.size(), "case", "cases"),
                          first.results.cases.size() == 1 ? "is" : "are", name));
  run.finished = finished;
  if (finished != nullptr) finished->hold(first.results);
  CompletedRun ran = run_with_progress(rest, run, progress);
  auto merged = merge_results({std::move(first), {kThisRun, std::move(ran.results)}}, false);
  if (auto* fault = std::get_if<std::string>(&merged)) return std::move(*fault);
  ran.results = std::get<Results>(std::move(merged));
  ran.results.shard = suite.share;
  return ran;
}

void ask_again(const Suite& suite, const RunOptions& run, Results& results) {
  if (interrupted()) return;
  const RerunCounts counts = rerun_unexpected(suite, run, results);
  if (counts.not_asked > 0)
    print_error(
        fmt::format("{} unexpected answers are not asked for again: at most {} are, of "
                    "those that came too late {}",
                    counts.not_asked, kMostReruns, kMostTimeoutReruns));
  results.interrupted = results.interrupted || counts.stopped;
}

}  // namespace

bool are_known(const std::vector<std::string>& renderers) {
  if (renderers.size() > kMostRenderers) {
    print_error(fmt::format("{} renderers are named, and a run may have {}; name fewer",
                            renderers.size(), kMostRenderers));
    return false;
  }
  std::set<std::string> seen;
  for (const std::string& renderer : renderers) {
    if (!is_known(renderer)) return false;
    const std::string name = split_name(renderer).name;
    if (seen.insert(name).second) continue;
    print_error(fmt::format("the renderer {} is named twice; name it once", name));
    return false;
  }
  return true;
}

void SuiteRunOptions::add_to(CLI::App& command) {
  add_repeatable(
      command, "--against", renderers,
      fmt::format("Renderer to compare with exact, repeatable: {}; NAME=RENDERER gives it a name",
                  known_renderer_names()));
  project.add_to(command);
  command.add_option("--jobs", jobs, "Threads (default: one per processor)")
      ->check(in_range(1, 256));
  command
      .add_option("--timeout", timeout,
                  "Seconds per case; a renderer's first answer may take "
                  "four times as long beside that, 5 to 30 seconds; comparing "
                  "it may take six times as long, at least 30 seconds")
      ->check(in_range(0.01, 3600.0));
  command.add_option("--progress", progress, "Progress on standard error")
      ->check(CLI::IsMember({"auto", "never"}));
  command.add_flag(
      "--invariance", invariance,
      "Draw each scene again, moved, masked, cut, behind others and unchanged, and hold "
      "the answers against each other (always so with --suite core and of one case "
      "that is explained)");
}

void SuiteRunOptions::take_project(CLI::App& command, bool asks_all) {
  project.take(command, renderers, kEveryOption, asks_all);
}

std::vector<std::string> SuiteRunOptions::named() const {
  return renderers.empty() ? std::vector<std::string>{kDefaultRenderer} : renderers;
}

RunOptions SuiteRunOptions::options(const Policy& policy, const Profiles& profiles,
                                    std::vector<KnownFaults> known) const {
  RunOptions run;
  run.policy = policy;
  run.profiles = profiles;
  run.renderers = named();
  run.renderer_options = {policy, std::chrono::milliseconds(static_cast<int>(timeout * 1000)),
                          worker_directory(), &interrupted(), project.folders};
  run.comparison_patience =
      std::max(6 * run.renderer_options.timeout, std::chrono::milliseconds(30'000));
  run.invariance = run.suggested_images = invariance;
  run.jobs = jobs > 0 ? jobs : static_cast<int>(std::thread::hardware_concurrency());
  run.stop = &interrupted();
  run.known = std::move(known);
  return run;
}

std::optional<Results> run_against(const Suite& suite, const Policy& policy,
                                   const Profiles& profiles, const SuiteRunOptions& options) {
  const RunOptions run = options.options(policy, profiles);
  if (!are_known(run.renderers)) return std::nullopt;
  const InterruptGuard guard;
  return run_with_progress(suite, run, options.progress).results;
}

std::optional<CompletedRun> run_judged(const Suite& suite, RunOptions run,
                                       const std::string& progress,
                                       std::optional<MergePart> begun) {
  if (!are_known(run.renderers)) return std::nullopt;
  const InterruptGuard guard;
  std::variant<CompletedRun, std::string> ran;
  if (begun)
    ran = run_rest(suite, run, progress, std::move(*begun));
  else
    ran = run_with_progress(suite, run, progress);
  if (const auto* fault = std::get_if<std::string>(&ran)) {
    print_error(*fault);
    return std::nullopt;
  }
  auto& completed = std::get<CompletedRun>(ran);
  Results& results = completed.results;
  results.whole_suite = run.whole_suite;
  Conclusion how{run.known, run.strict};
  if (run.reruns) how.ask_again = [&](Results& held) { ask_again(suite, run, held); };
  conclude(results, how);
  return std::move(completed);
}

namespace {

// The JSON files of a folder, in order of their names; of a file itself that.
std::vector<std::filesystem::path> json_files_of(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path, error))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

// Adds what a file holds to what is known of its driver. False, with the error printed, where it
// cannot be.
bool add_known_faults(const std::filesystem::path& path, std::vector<KnownFaults>& known) {
  if (leads_out_of_suite(path)) {
    print_error(fmt::format("{}: {}; {}", path.string(), kLeadsOut, kLeadsOutRemedy));
    return false;
  }
  const auto text = read_file(path);
  if (!text) return false;
  auto parsed = parse_known_faults(*text);
  if (const auto* message = std::get_if<std::string>(&parsed)) {
    print_error(fmt::format("{}: {}; put it right, or write it anew with `edgecase bless`",
                            path.string(), *message));
    return false;
  }
  auto& added = std::get<KnownFaults>(parsed);
  const auto found = std::ranges::find(known, added.driver, &KnownFaults::driver);
  if (found == known.end()) {
    known.push_back(std::move(added));
    return true;
  }
  for (KnownFault& fault : added.faults) {
    if (std::ranges::find(found->faults, fault.id, &KnownFault::id) != found->faults.end()) {
      print_error(
          fmt::format("{}: fault \"{}\" of {} stands in another file, too; give it another id",
                      path.string(), fault.id, added.driver));
      return false;
    }
    found->faults.push_back(std::move(fault));
  }
  return true;
}

}  // namespace

std::optional<std::vector<KnownFaults>> load_known_faults(const std::filesystem::path& folder,
                                                          const std::vector<std::string>& paths) {
  std::vector<std::filesystem::path> named(paths.begin(), paths.end());
  std::error_code error;
  if (named.empty()) {
    if (std::filesystem::is_directory(folder, error)) named.push_back(folder);
    const bool is_installed = folder.parent_path() == installed_suite();
    if (is_installed && std::filesystem::is_directory(kKnownFolder, error))
      named.emplace_back(kKnownFolder);
  }
  std::vector<KnownFaults> known;
  for (const auto& path : named)
    for (const auto& file : json_files_of(path))
      if (!add_known_faults(file, known)) return std::nullopt;
  return known;
}

ExitCode exit_code_of(const Results& results) {
  ExitCode exit = ExitCode::as_expected;
  if (!results.diagnostics.empty()) exit = worse(exit, ExitCode::usage);
  if (results.cases.empty() && results.diagnostics.empty()) exit = ExitCode::nothing_selected;
  if (!idle_renderers(results).empty()) exit = worse(exit, ExitCode::nothing_drawn);
  if (results.interrupted || has_grown(results)) exit = worse(exit, ExitCode::unexpected);
  for (const CaseOutline& one : results.cases.outlines()) {
    if (one.expect_failures > 0) exit = worse(exit, ExitCode::unexpected);
    for (const ResultOutline& answer : one.answers) exit = worse(exit, exit_code_of(answer));
  }
  return exit;
}

}  // namespace edgecase
