// SPDX-License-Identifier: MIT
//
// edgecase bless: from results, and from decisions on them, to expectations. Shows what would
// change;
// --apply changes it.
#include <fmt/format.h>

#include <fnmatch.h>

#include <algorithm>
#include <memory>

#include "model/renderer.h"
#include "reports/text.h"
#include "results/decisions.h"
#include "results/expectations.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/report_files.h"

namespace edgecase {
namespace {

struct BlessCommand {
  std::string results = "out/results.json";
  std::string folder = default_suite() + "/expectations";
  std::vector<std::string> filters;
  std::vector<std::string> renderers;
  std::string reason;
  std::string decisions;  // file
  bool apply = false;
};

std::string expectation_words(const Expectation& entry) {
  return fmt::format("{} {}: {}", name_of(entry.verdict), entry.fingerprint, entry.reason);
}

// Results and decisions are files that others may have written: what they hold is printed as
// one_line() shows it.
std::string decision_words(const Decision& decision) {
  return one_line(fmt::format("{} {}", decision.id, decision.renderer));
}

void print_change(const ExpectationChange& change) {
  const auto print = [&](char sign, const Expectation& entry) {
    fmt::print("{} {}\n", sign,
               one_line(fmt::format("{}: {}", change.id, expectation_words(entry))));
  };
  if (change.before != nullptr) print('-', *change.before);
  if (change.after) print('+', *change.after);
}

bool selected(const std::vector<std::string>& globs, const std::string& name) {
  return globs.empty() || std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) {
           return fnmatch(glob.c_str(), name.c_str(), 0) == 0;
         });
}

// The entries as they stand; none where there is no file yet.
std::optional<Expectations> load_current(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return Expectations{};
  const auto text = read_file(path);
  if (!text) return std::nullopt;
  auto parsed = parse_expectations(*text);
  if (auto* current = std::get_if<Expectations>(&parsed)) return std::move(*current);
  print_error(fmt::format("{}: {}", path.string(), std::get<std::string>(parsed)));
  return std::nullopt;
}

// Of a recording: those of what was recorded.
std::filesystem::path expectations_path(const BlessCommand& command, const RendererInfo& info) {
  return std::filesystem::path(command.folder) / expectations_file_name(known_as(info));
}

// Prints the changes of one renderer's file, and makes them where that is asked for.
ExitCode make_changes(const BlessCommand& command, const RendererInfo& info,
                      const Expectations& current, const std::vector<ExpectationChange>& changes) {
  const auto path = expectations_path(command, info);
  fmt::print("{}: {} change{}\n", path.string(), changes.size(), changes.size() == 1 ? "" : "s");
  for (const ExpectationChange& change : changes) print_change(change);
  if (!command.apply || changes.empty()) return ExitCode::as_expected;

  Expectations updated = current;
  updated.renderer = known_as(info);
  updated.measured = info.device + ", " + info.version;
  for (const ExpectationChange& change : changes) {
    if (change.after)
      updated.cases[change.id] = *change.after;
    else
      updated.cases.erase(change.id);
  }
  return write_file(path, expectations_text(updated)) ? ExitCode::as_expected : ExitCode::internal;
}

// Flakes are left as they are; whoever blesses should know.
void print_flakes(const BlessCommand& command, const Results& results, std::size_t index) {
  for (const CaseResults& one : results.cases)
    if (one.results[index].again && selected(command.filters, one.id))
      fmt::print("! {}: {}; such an answer cannot be expected\n", one_line(one.id),
                 one_line(one.results[index].expectation));
}

ExitCode bless_renderer(const BlessCommand& command, const Results& results, std::size_t index) {
  const RendererInfo& info = results.renderers[index];
  const auto current = load_current(expectations_path(command, info));
  if (!current) return ExitCode::usage;
  auto changes = plan_blessing(results, index, *current, command.reason);
  std::erase_if(changes, [&](const ExpectationChange& change) {
    return !selected(command.filters, change.id);
  });
  print_flakes(command, results, index);
  return make_changes(command, info, *current, changes);
}

// The decisions on one renderer's cases.
ExitCode decide_renderer(const BlessCommand& command, const Results& results, std::size_t index,
                         const std::vector<Decision>& decisions) {
  const RendererInfo& info = results.renderers[index];
  const auto current = load_current(expectations_path(command, info));
  if (!current) return ExitCode::usage;
  const auto outcomes = apply_decisions(results, index, *current, decisions);
  if (outcomes.empty()) return ExitCode::as_expected;
  ExitCode exit = ExitCode::as_expected;
  std::vector<ExpectationChange> changes;
  for (const DecisionOutcome& outcome : outcomes) {
    const Decision& decision = *outcome.decision;
    if (outcome.change) changes.push_back(*outcome.change);
    if (!outcome.refusal.empty()) {
      exit = ExitCode::unexpected;
      fmt::print("! {}: refused: {}\n", decision_words(decision), one_line(outcome.refusal));
    } else if (!decision.accepts) {
      fmt::print("  {}: rejected, and stays unexpected: {}\n", decision_words(decision),
                 one_line(decision.reason));
    }
  }
  return worse(exit, make_changes(command, info, *current, changes));
}

ExitCode decide(const BlessCommand& command, const Results& results) {
  const auto text = read_file(command.decisions);
  if (!text) return ExitCode::internal;
  const auto parsed = parse_decisions(*text);
  if (const auto* fault = std::get_if<std::string>(&parsed)) {
    print_error(fmt::format("{}: {}", command.decisions, *fault));
    return ExitCode::usage;
  }
  const auto& decisions = std::get<std::vector<Decision>>(parsed);
  ExitCode exit = ExitCode::as_expected;
  for (const Decision& decision : decisions) {
    if (std::ranges::find(results.renderers, decision.renderer, &RendererInfo::name) !=
        results.renderers.end())
      continue;
    fmt::print("! {}: refused: the results have no such renderer\n", decision_words(decision));
    exit = ExitCode::unexpected;
  }
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    exit = worse(exit, decide_renderer(command, results, r, decisions));
  return exit;
}

ExitCode bless_all(const BlessCommand& command, const Results& results) {
  ExitCode exit = ExitCode::as_expected;
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    if (selected(command.renderers, results.renderers[r].name))
      exit = worse(exit, bless_renderer(command, results, r));
  return exit;
}

ExitCode bless(const BlessCommand& command) {
  ExitCode exit = ExitCode::as_expected;
  const auto results = load_results(command.results, exit);
  if (!results) return exit;
  exit = command.decisions.empty() ? bless_all(command, *results) : decide(command, *results);
  if (!command.apply) fmt::print("Nothing is written. Run again with --apply to write this.\n");
  return exit;
}

}  // namespace

void add_bless_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "bless", "Show how expectations would change to match results; write them with --apply");
  auto options = std::make_shared<BlessCommand>();
  command->add_option("results", options->results, "Results file of `edgecase run`")
      ->capture_default_str();
  command->add_option("--folder", options->folder, "Folder of the expectations files")
      ->capture_default_str();
  add_repeatable(*command, "--filter", options->filters, "Only cases whose id matches; repeatable");
  add_repeatable(*command, "--against", options->renderers, "Only this renderer; repeatable");
  command->add_option("--reason", options->reason,
                      "Reason for new and changed entries (default: made from the causes found)");
  command
      ->add_option("--from", options->decisions,
                   "File of decisions on single cases; only what they accept is changed, and only "
                   "where nothing has changed since")
      ->excludes("--filter")
      ->excludes("--against")
      ->excludes("--reason");
  command->add_flag("--apply", options->apply, "Write the files");
  command->callback([options, &exit] { exit = bless(*options); });
}

}  // namespace edgecase
