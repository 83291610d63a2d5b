// SPDX-License-Identifier: MIT
#include "tools/edgecase/suite_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "casefile/loader.h"
#include "model/renderer.h"
#include "model/text.h"
#include "results/standing.h"
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

RunOptions run_options(const Policy& policy, const Profiles& profiles,
                       const SuiteRunOptions& options) {
  RunOptions run;
  run.policy = policy;
  run.profiles = profiles;
  run.renderers = options.renderers;
  run.renderer_options = {policy,
                          std::chrono::milliseconds(static_cast<int>(options.timeout * 1000)),
                          worker_directory(), &interrupted(), options.project.folders};
  run.comparison_patience =
      std::max(6 * run.renderer_options.timeout, std::chrono::milliseconds(30'000));
  run.jobs =
      options.jobs > 0 ? options.jobs : static_cast<int>(std::thread::hardware_concurrency());
  run.stop = &interrupted();
  return run;
}

Results run_with_progress(const Suite& suite, RunOptions& run, const SuiteRunOptions& options) {
  ProgressLine progress(options.progress, "cases");
  run.progress = [&](std::size_t done, std::size_t total) { progress.update(done, total); };
  Results results = run_suite(suite, run);
  run.progress = nullptr;
  results.tool = kToolName;
  return results;
}

constexpr const char* kThisRun = "this run";

// The first case of the rest, asked for what the renderers are: nobody should wait for the others
// to learn that they do not belong to the earlier run.
std::optional<RunDifference> difference_at_once(const MergePart& earlier, const Suite& rest,
                                                const RunOptions& run) {
  Suite first;
  if (!rest.cases.empty()) first.cases.push_back(rest.cases[0]);
  MergePart asked{kThisRun, run_suite(first, run)};
  asked.results.tool = kToolName;
  return difference_of_runs(earlier, asked);
}

// Runs what the earlier results do not hold, and merges.
std::variant<Results, std::string> run_rest(const Suite& suite, RunOptions& run,
                                            const SuiteRunOptions& options, MergePart earlier,
                                            FinishedCases* finished) {
  const std::string name = earlier.name;
  auto resumed = resume(suite, std::move(earlier));
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
  MergePart second{kThisRun, run_with_progress(rest, run, options)};
  auto merged = merge_results({std::move(first), std::move(second)}, false);
  if (auto* results = std::get_if<Results>(&merged)) results->shard = suite.share;
  return merged;
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
}

void SuiteRunOptions::take_project(CLI::App& command, bool asks_all) {
  project.take(command, renderers, kEveryOption, asks_all);
}

std::vector<std::string> SuiteRunOptions::named() const {
  return renderers.empty() ? std::vector<std::string>{kDefaultRenderer} : renderers;
}

std::optional<Results> run_against(const Suite& suite, const Policy& policy,
                                   const Profiles& profiles, SuiteRunOptions options) {
  options.renderers = options.named();
  if (!are_known(options.renderers)) return std::nullopt;
  RunOptions run = run_options(policy, profiles, options);
  const InterruptGuard guard;
  return run_with_progress(suite, run, options);
}

std::optional<Results> run_judged(const Suite& suite, const Policy& policy,
                                  const Profiles& profiles, SuiteRunOptions options,
                                  JudgedRun judged) {
  options.renderers = options.named();
  if (!are_known(options.renderers)) return std::nullopt;
  RunOptions run = run_options(policy, profiles, options);
  run.max_unexpected = judged.max_unexpected;
  if (run.max_unexpected > 0) run.known = judged.known;
  run.durations = judged.durations;
  run.likely_first = judged.likely_first;
  run.earlier = judged.compared;
  run.kept = judged.kept;
  const InterruptGuard guard;
  if (!judged.earlier) run.finished = judged.finished;
  auto ran = judged.earlier
                 ? run_rest(suite, run, options, std::move(*judged.earlier), judged.finished)
                 : run_with_progress(suite, run, options);
  run.finished = nullptr;
  if (const auto* fault = std::get_if<std::string>(&ran)) {
    print_error(*fault);
    return std::nullopt;
  }
  Results results = std::move(std::get<Results>(ran));
  results.whole_suite = judged.whole_suite;
  const auto apply = [&] {
    apply_known_faults(results, judged.known);
    if (judged.strict) hold_contested(results);
  };
  apply();
  if (!judged.reruns || interrupted()) return results;
  const RerunCounts counts = rerun_unexpected(suite, run, results);
  if (counts.not_asked > 0)
    print_error(
        fmt::format("{} unexpected answers are not asked for again: at most {} are, of "
                    "those that came too late {}",
                    counts.not_asked, kMostReruns, kMostTimeoutReruns));
  results.interrupted = results.interrupted || counts.stopped;
  apply();
  return results;
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
