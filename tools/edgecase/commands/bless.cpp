// SPDX-License-Identifier: MIT
//
// edgecase bless: updates known faults from results and from decisions on them. Shows the changes;
// --apply writes them.
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>

#include "model/renderer.h"
#include "model/text.h"
#include "reports/text.h"
#include "results/decisions.h"
#include "run/judging.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/report_files.h"
#include "tools/edgecase/project.h"

namespace edgecase {
namespace {

// The folder beside the cases of the working folder. Installed files are not written to: without
// such cases, `known` in the working folder.
std::string default_folder() {
  const std::filesystem::path suite = default_suite();
  return suite == installed_suite() ? kKnownFolder : (suite / kKnownFolder).string();
}

struct BlessCommand {
  std::string results = "out/results.zst";
  std::string folder = default_folder();
  std::vector<std::string> filters;
  std::vector<std::string> renderers;
  std::string reason;
  std::string link;
  std::string decisions;  // file
  ProjectOption project;
  bool strict = false;
  bool apply = false;
};

// The file of one driver, before and after the changes.
struct DriverFile {
  KnownFaults known;
  std::size_t changes = 0;
};

bool selected(const std::vector<std::string>& globs, const std::string& name) {
  return globs.empty() || std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) {
           return fnmatch(glob.c_str(), name.c_str(), 0) == 0;
         });
}

// Results and decisions may come from others, so their texts are printed by one_line().
std::string decision_words(const Decision& decision) {
  return one_line(fmt::format("{} {}", decision.id, decision.renderer));
}

// The entry as in the file, each line with a sign before it.
std::string entry_lines(char sign, const KnownFault& fault) {
  std::string text = known_faults_text({"", {fault}});
  const std::size_t begin = text.find("    {");
  text = text.substr(begin, text.rfind("\n  ]") - begin);
  std::string lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines += fmt::format("{} {}\n", sign, one_line(text.substr(at, end - at)));
    at = end + 1;
  }
  return lines;
}

std::string lines_of(const FaultChange& change) {
  return (change.before ? entry_lines('-', *change.before) : "") +
         (change.after ? entry_lines('+', *change.after) : "");
}

// All changes of one call of the command.
class Blessing {
 public:
  Blessing(const BlessCommand& command, Results& results) : command_(command), results_(results) {}

  // Reads the files of the renderers' drivers.
  ExitCode load() {
    for (const RendererInfo& info : results_.renderers) {
      const std::string driver = driver_of(info);
      const auto path = path_of(driver);
      DriverFile& file = files_[driver];
      file.known.driver = driver;
      std::error_code error;
      if (!std::filesystem::exists(path, error)) continue;
      const auto text = read_file(path);
      if (!text) return ExitCode::internal;
      auto parsed = parse_known_faults(*text);
      if (const auto* sentence = std::get_if<std::string>(&parsed)) {
        print_error(fmt::format("{}: {}", path.string(), *sentence));
        return ExitCode::usage;
      }
      file.known = std::move(std::get<KnownFaults>(parsed));
    }
    return ExitCode::as_expected;
  }

  void bless_all() {
    for (std::size_t r = 0; r < results_.renderers.size(); ++r) {
      if (!selected(command_.renderers, results_.renderers[r].name)) continue;
      apply_current();
      add_flakes(r);
      BlessingOptions options{{}, command_.reason, command_.link};
      if (!command_.filters.empty())
        options.is_wanted = [this](const std::string& id) {
          return selected(command_.filters, id);
        };
      DriverFile& file = file_of(r);
      take(file, plan_blessing(results_, r, file.known, options));
    }
  }

  ExitCode decide(const std::vector<Decision>& decisions) {
    ExitCode exit = ExitCode::as_expected;
    for (const Decision& decision : decisions) {
      if (std::ranges::find(results_.renderers, decision.renderer, &RendererInfo::name) !=
          results_.renderers.end())
        continue;
      text_ += fmt::format("! {}: refused: the results have no such renderer\n",
                           decision_words(decision));
      exit = ExitCode::unexpected;
    }
    for (std::size_t r = 0; r < results_.renderers.size(); ++r) {
      apply_current();
      const auto outcomes = weigh_decisions(results_, r, decisions);
      for (const DecisionOutcome& outcome : outcomes) {
        add_outcome(outcome);
        if (!outcome.refusal.empty()) exit = ExitCode::unexpected;
      }
      DriverFile& file = file_of(r);
      take(file, plan_decisions(results_, r, file.known, outcomes));
    }
    return exit;
  }

  // Writes the files if --apply is given, then prints the changes.
  ExitCode finish() {
    ExitCode exit = ExitCode::as_expected;
    for (const auto& [driver, file] : files_) {
      text_ += fmt::format("{}: {}\n", path_of(driver).string(),
                           counted(file.changes, "change", "changes"));
      if (command_.apply && file.changes > 0 &&
          !write_file(path_of(driver), known_faults_text(file.known)))
        exit = ExitCode::internal;
    }
    if (!command_.apply) text_ += "Nothing is written. Run again with --apply to write this.\n";
    fmt::print("{}", text_);
    return exit;
  }

 private:
  std::filesystem::path path_of(const std::string& driver) const {
    return std::filesystem::path(command_.folder) / file_name_about(driver);
  }

  DriverFile& file_of(std::size_t renderer) {
    return files_.at(driver_of(results_.renderers[renderer]));
  }

  // Applies the present known faults to the results: a fault added for one renderer holds for
  // others of the same driver.
  void apply_current() {
    std::vector<KnownFaults> known;
    for (const auto& [driver, file] : files_) known.push_back(file.known);
    conclude(results_, {known, command_.strict});
  }

  void take(DriverFile& file, const std::vector<FaultChange>& changes) {
    for (const FaultChange& change : changes) text_ += lines_of(change);
    file.known = with_changes(file.known, changes);
    file.changes += changes.size();
  }

  // Mentions flakes, which stay unexpected.
  void add_flakes(std::size_t renderer) {
    for (const CaseOutline& one : results_.cases.outlines())
      if (one.answers[renderer].again && selected(command_.filters, one.id))
        text_ += fmt::format("! {}: {}; such an answer cannot be known\n", one_line(one.id),
                             one_line(one.answers[renderer].standing_reason));
  }

  void add_outcome(const DecisionOutcome& outcome) {
    const Decision& decision = *outcome.decision;
    if (!outcome.refusal.empty())
      text_ +=
          fmt::format("! {}: refused: {}\n", decision_words(decision), one_line(outcome.refusal));
    else if (!decision.accepts)
      text_ += fmt::format("  {}: rejected, and stays unexpected: {}\n", decision_words(decision),
                           one_line(decision.reason));
  }

  const BlessCommand& command_;
  Results& results_;
  std::map<std::string, DriverFile> files_;  // by driver
  std::string text_;                         // printed at the end
};

std::optional<std::vector<Decision>> load_decisions(const std::string& path, ExitCode& exit) {
  const auto text = read_file(path);
  exit = ExitCode::internal;
  if (!text) return std::nullopt;
  auto parsed = parse_decisions(*text);
  exit = ExitCode::usage;
  if (auto* decisions = std::get_if<std::vector<Decision>>(&parsed)) return std::move(*decisions);
  print_error(fmt::format("{}: {}", path, std::get<std::string>(parsed)));
  return std::nullopt;
}

ExitCode bless(const BlessCommand& command) {
  ExitCode exit = ExitCode::as_expected;
  auto results = load_results(command.results, exit);
  if (!results) return exit;
  Blessing blessing(command, *results);
  exit = blessing.load();
  if (exit != ExitCode::as_expected) return exit;
  if (command.decisions.empty()) {
    blessing.bless_all();
    return blessing.finish();
  }
  const auto decisions = load_decisions(command.decisions, exit);
  if (!decisions) return exit;
  exit = blessing.decide(*decisions);
  return worse(exit, blessing.finish());
}

}  // namespace

void add_bless_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "bless", "Show how known faults would change to match results; write them with --apply");
  auto options = std::make_shared<BlessCommand>();
  command->add_option("results", options->results, "Results file of `edgecase run`")
      ->capture_default_str();
  command->add_option("--folder", options->folder, "Folder of the known faults")
      ->capture_default_str();
  add_repeatable(*command, "--filter", options->filters, "Only cases whose id matches; repeatable");
  add_repeatable(*command, "--against", options->renderers, "Only this renderer; repeatable");
  command->add_option("--reason", options->reason,
                      "Reason of new faults (default: made of what was found)");
  command->add_option("--link", options->link, "Where new faults are reported");
  command
      ->add_option("--from", options->decisions,
                   "File of decisions on single cases; only what they accept is changed, and only "
                   "where nothing has changed since")
      ->excludes("--filter")
      ->excludes("--against")
      ->excludes("--reason")
      ->excludes("--link");
  add_strict_option(*command, options->strict);
  command->add_flag("--apply", options->apply, "Write the files");
  options->project.add_config_to(*command);
  command->callback([options, command, &exit] {
    if (const auto project = find_project(options->project.config))
      project->give(*command, kEveryOption);
    exit = bless(*options);
  });
}

}  // namespace edgecase
