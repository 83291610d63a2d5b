// SPDX-License-Identifier: MIT
#include "tools/edgecase/suite_run.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <set>
#include <thread>

#include "model/counted.h"
#include "model/renderer.h"
#include "run/merge.h"
#include "run/renderer_names.h"
#include "run/rerun.h"
#include "run/resume.h"
#include "run/run.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/output/progress_line.h"

namespace edgecase {
namespace {

bool is_known(const std::string& renderer) {
  auto made = make_renderer(renderer, {{}, std::chrono::seconds(1), worker_directory(), {}});
  if (const auto* error = std::get_if<std::string>(&made)) {
    print_error(*error);
    return false;
  }
  return true;
}

ExitCode exit_code_of(const Result& result) {
  if (!is_unexpected(result.standing)) return ExitCode::as_expected;
  if (result.standing == Standing::flake) return ExitCode::unexpected;
  if (result.failure && result.failure->kind != FailureKind::unsupported) return ExitCode::renderer;
  return ExitCode::unexpected;
}

RunOptions run_options(const Policy& policy, const std::map<std::string, Policy>& profiles,
                       const SuiteRunOptions& options) {
  RunOptions run;
  run.policy = policy;
  run.profiles = profiles;
  run.renderers = options.renderers;
  run.renderer_options = {policy,
                          std::chrono::milliseconds(static_cast<int>(options.timeout * 1000)),
                          worker_directory(), &interrupted()};
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
  if (!rest.cases.empty()) first.cases = {rest.cases.front()};
  MergePart asked{kThisRun, run_suite(first, run)};
  asked.results.tool = kToolName;
  return difference_of_runs(earlier, asked);
}

// Runs what the earlier results do not hold, and merges.
std::variant<Results, std::string> run_rest(const Suite& suite, RunOptions& run,
                                            const SuiteRunOptions& options, MergePart earlier) {
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
  MergePart second{kThisRun, run_with_progress(rest, run, options)};
  auto merged = merge_results({std::move(first), std::move(second)}, false);
  if (auto* results = std::get_if<Results>(&merged)) results->shard = suite.share;
  return merged;
}

}  // namespace

bool are_known(const std::vector<std::string>& renderers) {
  std::set<std::string> seen;
  for (const std::string& renderer : renderers) {
    if (!is_known(renderer)) return false;
    if (seen.insert(renderer).second) continue;
    print_error(fmt::format("the renderer {} is named twice; name it once", renderer));
    return false;
  }
  return true;
}

void SuiteRunOptions::add_to(CLI::App& command) {
  add_repeatable(
      command, "--against", renderers,
      "Renderer to compare with exact, repeatable: osmesa:llvmpipe, osmesa:softpipe, "
      "egl:llvmpipe, egl:softpipe, egl:zink, egl:zink-swiftshader, egl:deviceN, egl-es:llvmpipe, "
      "egl-es:softpipe, egl-es:zink, egl-es:deviceN, exec:PROGRAM, recording:FILE, exact");
  command.add_option("--jobs", jobs, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 256));
  command.add_option("--timeout", timeout, "Seconds per case")->check(CLI::Range(0.01, 3600.0));
  command.add_option("--progress", progress, "Progress on standard error")
      ->check(CLI::IsMember({"auto", "never"}));
}

std::string default_renderer() {
  for (const char* library : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
    void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    if (handle == nullptr) continue;
    dlclose(handle);
    return "osmesa:llvmpipe";
  }
  return "egl:llvmpipe";
}

std::vector<std::string> SuiteRunOptions::named() const {
  return renderers.empty() ? std::vector{default_renderer()} : renderers;
}

std::optional<Results> run_against(const Suite& suite, const Policy& policy,
                                   const std::map<std::string, Policy>& profiles,
                                   SuiteRunOptions options) {
  options.renderers = options.named();
  if (!are_known(options.renderers)) return std::nullopt;
  RunOptions run = run_options(policy, profiles, options);
  const InterruptGuard guard;
  return run_with_progress(suite, run, options);
}

std::optional<Results> run_expecting(const Suite& suite, const Policy& policy,
                                     const std::map<std::string, Policy>& profiles,
                                     SuiteRunOptions options, ExpectantRun expectant) {
  options.renderers = options.named();
  if (!are_known(options.renderers)) return std::nullopt;
  RunOptions run = run_options(policy, profiles, options);
  run.max_unexpected = expectant.max_unexpected;
  if (run.max_unexpected > 0) run.expectations = expectant.expectations;
  const InterruptGuard guard;
  auto ran = expectant.earlier ? run_rest(suite, run, options, std::move(*expectant.earlier))
                               : run_with_progress(suite, run, options);
  if (const auto* fault = std::get_if<std::string>(&ran)) {
    print_error(*fault);
    return std::nullopt;
  }
  Results results = std::move(std::get<Results>(ran));
  results.whole_suite = expectant.whole_suite;
  apply_all_expectations(expectant.expectations, expectant.strict, results);
  if (!expectant.reruns || interrupted()) return results;
  const RerunCounts counts = rerun_unexpected(suite, run, results);
  if (counts.not_asked > 0)
    print_error(
        fmt::format("{} unexpected answers are not asked for again: at most {} are, of "
                    "those that came too late {}",
                    counts.not_asked, kMostReruns, kMostTimeoutReruns));
  results.interrupted = results.interrupted || counts.stopped;
  apply_all_expectations(expectant.expectations, expectant.strict, results);
  return results;
}

std::optional<std::vector<Expectations>> load_expectations(
    const std::filesystem::path& folder, const std::vector<std::string>& files,
    const std::vector<std::string>& renderers) {
  // What a recording was made of is known when it is opened.
  const bool all = std::ranges::any_of(
      renderers, [](const std::string& name) { return name.starts_with(kRecordingPrefix); });
  const WantedRenderer is_wanted = [&](const std::string& renderer) {
    return all || std::ranges::find(renderers, renderer) != renderers.end();
  };
  std::vector<std::filesystem::path> paths(files.begin(), files.end());
  std::error_code error;
  if (files.empty())
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
      if (entry.path().extension() == ".json") paths.push_back(entry.path());
  std::vector<Expectations> result;
  for (const auto& path : paths) {
    const auto text = read_file(path);
    if (!text) return std::nullopt;
    // What somebody names is read to its end, whomever it is about.
    auto parsed = parse_expectations(*text, files.empty() ? is_wanted : WantedRenderer());
    if (const auto* message = std::get_if<std::string>(&parsed)) {
      print_error(fmt::format("{}: {}; put it right, or make it anew with `edgecase bless`",
                              path.string(), *message));
      return std::nullopt;
    }
    auto& expectations = std::get<Expectations>(parsed);
    if (is_wanted(expectations.renderer)) result.push_back(std::move(expectations));
  }
  return result;
}

void apply_all_expectations(const std::vector<Expectations>& expectations, bool strict,
                            Results& results) {
  results.missing.clear();
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const Expectations* own = nullptr;
    for (const Expectations& candidate : expectations)
      if (candidate.renderer == known_as(results.renderers[r])) own = &candidate;
    apply_expectations(results, r, own);
    if (own != nullptr)
      std::ranges::move(missing_cases(results, *own), std::back_inserter(results.missing));
  }
  if (strict) hold_contested(results);
}

ExitCode exit_code_of(const Results& results) {
  ExitCode exit = ExitCode::as_expected;
  if (!results.diagnostics.empty()) exit = worse(exit, ExitCode::usage);
  if (results.cases.empty() && results.diagnostics.empty()) exit = ExitCode::nothing_selected;
  if (results.interrupted || !results.missing.empty()) exit = worse(exit, ExitCode::unexpected);
  for (const CaseResults& one : results.cases) {
    if (!one.expect_failures.empty()) exit = worse(exit, ExitCode::unexpected);
    for (const Result& result : one.results) exit = worse(exit, exit_code_of(result));
  }
  return exit;
}

}  // namespace edgecase
