// SPDX-License-Identifier: MIT
//
// edgecase run: the suite against renderers, judged, held against known faults, reported.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "model/text.h"
#include "reports/summary.h"
#include "reports/text.h"
#include "run/record.h"
#include "run/renderers.h"
#include "run/rerun.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/earlier_results.h"
#include "tools/edgecase/interrupt.h"
#include "tools/edgecase/journal.h"
#include "tools/edgecase/output/delivery.h"
#include "tools/edgecase/suite_run.h"
#include "tools/edgecase/watched_files.h"

namespace edgecase {
namespace {

struct RunCommand {
  SelectionOptions selection;
  PolicyOptions policy;
  SuiteRunOptions run;
  ReportFiles files;
  std::vector<std::string> known;
  std::string color = "auto";
  bool list = false;
  bool last_failed = false;
  bool resume = false;
  bool is_json_named = false;  // on the command line, and not by a project
  bool no_rerun = false;
  bool ask_all = false;
  bool strict = false;
  bool watch = false;
  std::size_t max_failures = 0;
  std::string since;
  std::string fail_on = "violations";
  std::string timings;
};

// Narrows the selection to what was not as expected in the last results; otherwise the exit code
// that this deserves, with the reason printed.
std::optional<ExitCode> narrow_to_last_failed(const RunCommand& command, Selection& selection) {
  const std::string path = command.files.json.empty() || command.files.json == "-"
                               ? ReportFiles::kDefaultJson
                               : command.files.json;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    print_error(
        fmt::format("--last-failed finds no last results: there is no {}; run once without "
                    "it, or name the results with --json",
                    path));
    return ExitCode::usage;
  }
  ExitCode exit = ExitCode::as_expected;
  const auto last = load_results(path, exit);
  if (!last) return exit;
  selection.only = unexpected_cases(*last);
  if (!selection.only->ids.empty() || !selection.only->files.empty()) return std::nullopt;
  print_error(
      fmt::format("nothing failed: in {} all is as expected, {}; run without --last-failed to run "
                  "them again",
                  path, counted(last->cases.size(), "case", "cases")));
  return ExitCode::nothing_selected;
}

// The run to go on with, where there is one; otherwise the exit code that asking for it deserves,
// with the reason printed.
std::variant<EarlierRun, ExitCode> earlier_run(const RunCommand& command, const UserKey& key) {
  if (!command.resume) return EarlierRun{std::nullopt, true};
  const std::string path = command.files.json_path();
  if (path.empty()) {
    print_error("--resume goes on with a file and writes it anew; name it with --json");
    return ExitCode::usage;
  }
  return run_to_resume(path, command.is_json_named, key);
}

// Says how to go on where not all was done, and the file to go on with is there.
void print_way_on(const RunCommand& command, const Results& results) {
  const std::string path = command.files.json_path();
  std::error_code error;
  if (!results.interrupted || path.empty() || !std::filesystem::is_regular_file(path, error))
    return;
  print_error(fmt::format(
      "{} has what was finished; the same command with --resume goes on with the rest", path));
}

ExitCode print_list(const Suite& suite) {
  for (std::size_t i = 0; i < suite.cases.size(); ++i)
    fmt::print("{}\n", one_line(suite.cases.id(i)));
  if (!suite.diagnostics.empty()) return ExitCode::usage;
  if (!suite.cases.empty()) return ExitCode::as_expected;
  print_nothing_selected();
  return ExitCode::nothing_selected;
}

// What --fail-on makes of the exit code that the results deserve. What could not be done stays.
ExitCode failing_on(const RunCommand& command, const Results& results, ExitCode exit,
                    const std::optional<Comparison>& since) {
  const bool is_about_answers = exit == ExitCode::as_expected || exit == ExitCode::unexpected ||
                                exit == ExitCode::renderer || exit == ExitCode::nothing_drawn;
  if (command.fail_on == "violations" || !is_about_answers || results.interrupted) return exit;
  const bool fails = command.fail_on == "changes" && differs(*since);
  return fails ? ExitCode::unexpected : ExitCode::as_expected;
}

// False, with the error printed, where they cannot be written.
bool write_timings(const std::string& path, const Durations& durations) {
  return path.empty() ||
         write_file(path, [&](std::ostream& out) { write_durations(durations, out); });
}

// A recording is opened when it is asked, since that may take long.
bool are_renderers_known(const SuiteRunOptions& options) {
  std::vector<std::string> names = options.named();
  if (names.size() <= kMostRenderers)
    std::erase_if(names, [](const std::string& name) { return is_recording(name); });
  return are_known(names);
}

// The latest results of a run that is watched, between runs.
struct Watched {
  std::optional<Results> latest;
  bool keeps_answers = false;  // only case files have changed: what others gave is kept
};

// The run to go on with.
std::variant<EarlierRun, ExitCode> kept_answers(const RunCommand& command, const Watched* watched,
                                                const UserKey& key) {
  if (watched == nullptr || !watched->latest) return earlier_run(command, key);
  EarlierRun latest{std::nullopt, true};
  if (watched->keeps_answers) latest.run = MergePart{"the latest run", *watched->latest};
  return latest;
}

// Results that know what was found of many answers of the run: those of --since, of the run before
// that is watched, or those that the run is to replace.
struct ComparedBefore {
  FoundResults found;              // in the place of the run's own
  const Results* named = nullptr;  // or others
  std::string path;                // of their file; empty: they have none

  // Null: there are none.
  const Results* get() const {
    return named != nullptr ? named : found.results ? &*found.results : nullptr;
  }
  // What the summary says of `kept` answers that were taken over, or why none were.
  std::string note(std::size_t kept) const {
    if (!found.doubt.empty())
      return fmt::format("nothing is taken over from {}: {}; --since {} takes it over all the same",
                         path, found.doubt, path);
    if (kept == 0 || path.empty()) return "";
    return fmt::format("{} as in {}, and not compared anew; --ask-all compares {}",
                       counted(kept, "answer is", "answers are"), path, kept == 1 ? "it" : "them");
  }
};

ComparedBefore compared_before(const RunCommand& command, const std::optional<Results>& since,
                               const Watched* watched, const UserKey& key) {
  ComparedBefore before;
  if (command.ask_all || command.resume || command.max_failures > 0) return before;
  if (since) return {{}, &*since, command.since};
  if (watched != nullptr && watched->latest) return {{}, &*watched->latest, ""};
  before.path = command.files.json_path();
  before.found = own_results(before.path, key);
  return before;
}

// One line, what has changed since the latest results, and the files.
ExitCode deliver_changes(const Results& latest, const Results& results, const ReportFiles& files,
                         const std::string& color, double seconds) {
  std::cout << fmt::format("{}, {} unexpected, {:.1f} s\n",
                           counted(results.cases.size(), "case", "cases"),
                           count_unexpected(results), seconds);
  const auto compared = compare_results(latest, results);
  if (const auto* comparison = std::get_if<Comparison>(&compared)) {
    if (differs(*comparison))
      write_changes(*comparison, use_color(color, STDOUT_FILENO), std::cout);
    else
      std::cout << "nothing has changed\n";
  }
  return files.write(results) ? exit_code_of(results) : ExitCode::internal;
}

// The files and folders that say what the cases are and how they are judged.
std::vector<std::filesystem::path> judging_files(const RunCommand& command,
                                                 const Selection& selection) {
  std::vector<std::filesystem::path> files = {command.policy.policy};
  files.insert(files.end(), command.known.begin(), command.known.end());
  for (const char* folder : {kKnownFolder, "policies", "profiles"})
    files.push_back(suite_folder(selection) / folder);
  return files;
}

// False, with the error printed, where the run would write what it reads, or two reports to one
// file.
bool are_outputs_distinct(const RunCommand& command, const Selection& selection) {
  std::vector<WrittenFile> outputs = command.files.outputs();
  outputs.push_back({"--timings", command.timings});
  std::vector<std::filesystem::path> inputs = judging_files(command, selection);
  inputs.insert(inputs.end(), selection.paths.begin(), selection.paths.end());
  for (const auto& [renderer, folder] : command.run.project.folders)
    inputs.push_back(std::filesystem::path(folder) / "edgecase.toml");
  if (!command.run.project.config.empty()) inputs.emplace_back(command.run.project.config);
  for (const std::string& renderer : command.run.named())
    if (is_recording(renderer))
      inputs.emplace_back(split_name(renderer).address.substr(kRecordingPrefix.size()));
  for (auto& file : program_files(command.run.named(), command.run.project.folders))
    inputs.push_back(std::move(file));
  return are_distinct(outputs, inputs);
}

ExitCode run(const RunCommand& command, Watched* watched = nullptr) {
  const auto start = std::chrono::steady_clock::now();
  if (command.fail_on == "changes" && command.since.empty()) {
    print_error("--fail-on changes needs earlier results; name them with --since");
    return ExitCode::usage;
  }
  Selection selection = command.selection.selection();
  // A misspelt name is told before thousands of cases are loaded.
  if (!command.list && !are_renderers_known(command.run)) return ExitCode::usage;
  if (!command.list && !are_outputs_distinct(command, selection)) return ExitCode::usage;
  std::optional<Results> since;
  if (!command.list && !command.since.empty()) {
    ExitCode exit = ExitCode::as_expected;
    since = load_results(command.since, exit);
    if (!since) return exit;
  }
  if (command.last_failed)
    if (const auto exit = narrow_to_last_failed(command, selection)) return *exit;
  const auto policy = command.policy.load(selection, command.run.renderers);
  if (!policy) return ExitCode::usage;
  const Suite suite = load_suite(selection);
  print_diagnostics(suite.diagnostics);
  if (command.list) return print_list(suite);
  // Of what was asked for nothing is there: what an earlier run wrote stays.
  if (suite.is_misspelt) return ExitCode::usage;
  auto known = load_known_faults(suite_folder(selection) / kKnownFolder, command.known);
  const auto profiles = load_profiles(selection, command.run.named());
  if (!known || !profiles) return ExitCode::usage;
  const UserKey key;
  auto found = kept_answers(command, watched, key);
  if (const auto* exit = std::get_if<ExitCode>(&found)) return *exit;
  auto& [earlier, is_own] = std::get<EarlierRun>(found);
  RunOptions options = command.run.options(*policy, *profiles, std::move(*known));
  options.max_unexpected = command.max_failures;
  options.reruns = !command.no_rerun;
  options.whole_suite = is_whole_suite(selection);
  options.strict = command.strict;
  options.likely_first = !command.ask_all;
  options.invariance = command.run.invariance || command.selection.suite == "core";
  ReportFiles files = command.files;
  // What was taken over from another's file is not this user's work.
  if (is_own && (!since || command.ask_all)) files.key = key.get();
  Journal journal(watched == nullptr ? files.json_path() : "", files.key);
  options.finished = &journal;
  files.results_are_written = [&journal] { journal.remove(); };
  if (!earlier && !suite.cases.empty()) journal.start();
  const ComparedBefore before = compared_before(command, since, watched, key);
  options.earlier = before.get();
  // What was found is written although somebody asks to stop meanwhile.
  const InterruptGuard guard;
  auto ran = run_judged(suite, std::move(options), command.run.progress, std::move(earlier));
  if (!ran) return ExitCode::usage;
  auto& [results, durations, kept] = *ran;
  if (!command.timings.empty()) files.durations = std::move(durations);
  if (since) {
    ExitCode exit = ExitCode::as_expected;
    files.since = changes_since(std::move(*since), results, exit);
    if (!files.since) return exit;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  ExitCode delivered =
      watched != nullptr && watched->latest
          ? deliver_changes(*watched->latest, results, files, command.color, took.count())
          : deliver_results(results, files, command.color,
                            RunCost{took.count(), kept, before.note(kept)});
  if (!write_timings(command.timings, files.durations)) delivered = ExitCode::internal;
  const ExitCode exit = failing_on(command, results, delivered, files.since);
  if (exit != ExitCode::internal) print_way_on(command, results);
  if (watched != nullptr) watched->latest = std::move(results);
  return exit;
}

// Runs, and runs again what a saved file touches, until somebody interrupts.
ExitCode watch(const RunCommand& command) {
  constexpr auto kPause = std::chrono::milliseconds(100);
  const InterruptGuard guard;
  Watched watched;
  const Selection selection = command.selection.selection();
  const std::vector<std::filesystem::path> judging = judging_files(command, selection);
  const auto cases_now = [&] { return WrittenTimes(json_files(selection.paths)); };
  const auto others_now = [&] {
    auto files = json_files(judging);
    for (auto& file : program_files(command.run.named(), command.run.project.folders))
      files.push_back(std::move(file));
    return WrittenTimes(files);
  };
  WrittenTimes cases = cases_now();
  WrittenTimes others = others_now();
  ExitCode exit = run(command, &watched);
  std::fflush(stdout);  // for whoever reads a pipe
  print_error("watching case files, policies and programs; Ctrl-C ends this");
  while (!interrupted()) {
    std::this_thread::sleep_for(kPause);
    WrittenTimes new_cases = cases_now();
    WrittenTimes new_others = others_now();
    const auto saved = new_cases.since(cases);
    const auto saved_others = new_others.since(others);
    if (saved.empty() && saved_others.empty()) continue;
    cases = std::move(new_cases);
    others = std::move(new_others);
    for (const auto* files : {&saved, &saved_others})
      for (const auto& file : *files) std::cout << '\n' << one_line(file.string()) << " is saved\n";
    watched.keeps_answers = saved_others.empty();
    exit = run(command, &watched);
    std::cout.flush();
    std::fflush(stdout);
  }
  return exit;
}

}  // namespace

void add_run_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "run", "Compare renderers with the exact side, judge every difference, write reports");
  auto options = std::make_shared<RunCommand>();
  options->selection.add_to(*command, true);
  options->policy.add_to(*command);
  add_strict_option(*command, options->strict);
  options->run.add_to(*command);
  options->files.add_to(*command);
  add_known_option(*command, options->known);
  command->add_option("--since", options->since,
                      "Earlier results file: the summary and the HTML report tell every change "
                      "against it, legal ones too, and what it says of answers that are, to the "
                      "bit, the same is believed");
  command
      ->add_option("--fail-on", options->fail_on,
                   "What ends with exit code 1: unexpected violations, any change since the "
                   "results of --since, or nothing")
      ->check(CLI::IsMember({"violations", "changes", "nothing"}))
      ->capture_default_str();
  command->add_option("--timings", options->timings,
                      "File for how long each case took; JUnit XML and CTRF then tell it, too");
  command->add_option("--color", options->color, "Colours in the summary")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  command->add_flag("--last-failed", options->last_failed,
                    "Only the cases that were not as expected in the last results: those in the "
                    "file that --json names, or in out/results.zst");
  command
      ->add_flag("--resume", options->resume,
                 "Continue a run that ended early or was killed: keep the results of unchanged "
                 "cases from the file that --json names, or from out/results.zst if a run of yours "
                 "wrote it, and run the rest")
      ->excludes("--last-failed");
  command
      ->add_option("--max-failures", options->max_failures,
                   "End after so many unexpected cases, and report the finished ones")
      ->check(in_range(std::size_t{1}, std::size_t{1'000'000'000}));
  command->add_flag(
      "--no-rerun", options->no_rerun,
      "Do not ask again after an unexpected answer; the second answer reveals flakes");
  command->add_flag("--ask-all", options->ask_all,
                    "Compare every answer anew, also those that are, to the bit, as in the earlier "
                    "results, and look for causes among all alternatives, and not first among "
                    "those that the renderer's profile has: the same results, later");
  command
      ->add_flag(
          "--watch", options->watch,
          "Stay, and when a case file, policy, known fault or program of exec: is saved, run "
          "again what it touches, print what changed, and renew the reports")
      ->excludes("--last-failed")
      ->excludes("--resume");
  command->add_flag("--list", options->list, "Only list the ids of the selected cases");
  command->callback([options, command, &exit] {
    options->run.project.runs = !options->list;
    options->is_json_named = !options->files.json.empty();
    options->run.take_project(*command);
    exit = options->watch && !options->list ? watch(*options) : run(*options);
  });
}

}  // namespace edgecase
