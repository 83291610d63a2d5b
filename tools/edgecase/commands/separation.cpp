// SPDX-License-Identifier: MIT
//
// edgecase separation: the number of cases that distinguish each pair of a rule's alternatives, and
// the shortest list of cases that distinguishes them all.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "model/text.h"
#include "reports/text.h"
#include "suite/core_suite.h"
#include "suite/separation.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/report_files.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostListed = 8;  // weak pairs of a rule

struct SeparationCommand {
  SelectionOptions selection;
  std::size_t least = 0;
  bool full = false;
  bool cover = false;
  std::string list;                // file of the cover's ids
  std::vector<std::string> shown;  // files of results
};

// The first lines of the list; the second is what a test finds in the core, too.
std::string head_of_list(const CoreSuite& core, const SeparationCommand& command) {
  return fmt::format(
      "# The core of the suite. Renewed by `edgecase separation --cover --least {}{} -o "
      "cases/core.txt`.\n# {} of alternatives, the rulings of {}.\n",
      std::max<std::size_t>(command.least, 1), command.shown.empty() ? "" : " --shown RESULTS",
      counted(core.pairs, "pair", "pairs"), counted(core.rules, "rule", "rules"));
}

void print_matrix(const SeparationMatrix& matrix) {
  std::size_t width = 4;
  for (const std::string& name : matrix.alternatives) width = std::max(width, name.size());
  for (std::size_t i = 0; i < matrix.alternatives.size(); ++i) {
    fmt::print("  {:<{}}", matrix.alternatives[i], width);
    for (std::size_t j = 0; j < i; ++j) fmt::print(" {:>5}", matrix.cases[i][j]);
    fmt::print("\n");
  }
}

// Prints the pairs that fewer than `least` cases distinguish.
std::size_t print_weak_pairs(const SeparationMatrix& matrix, std::size_t least) {
  std::size_t weak = 0;
  for (std::size_t i = 0; i < matrix.alternatives.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (matrix.cases[i][j] >= least) continue;
      if (++weak > kMostListed) continue;
      fmt::print("  {} and {}: {}\n", matrix.alternatives[j], matrix.alternatives[i],
                 counted(matrix.cases[i][j], "case", "cases"));
    }
  if (weak > kMostListed)
    fmt::print("  and {}\n", counted(weak - kMostListed, "more pair", "more pairs"));
  return weak;
}

ExitCode print_cover(const SeparationCommand& command, const Suite& suite) {
  CoreSuite core = find_core(suite.cases, std::max<std::size_t>(command.least, 1));
  fmt::print(
      "{} of {} tell apart the {} of alternatives that all tell apart, and touch the rulings of "
      "{}; no list has fewer than {}\n",
      core.ids.size(), counted(suite.cases.size(), "case", "cases"),
      counted(core.pairs, "pair", "pairs"), counted(core.rules, "rule", "rules"), core.fewest);
  for (const std::string& file : command.shown) {
    ExitCode exit = ExitCode::as_expected;
    const auto results = load_results(file, exit);
    if (!results) return exit;
    fmt::print("{} more show what the renderers of {} do wrong\n", add_shown(*results, core.ids),
               one_line(file));
  }
  for (const std::string& rule : core.unnamed) fmt::print("  no case names {}\n", rule);
  if (command.list.empty()) {
    for (const std::string& id : core.ids) fmt::print("{}\n", one_line(id));
    return ExitCode::as_expected;
  }
  return write_file(command.list,
                    fmt::format("{}{}\n", head_of_list(core, command), fmt::join(core.ids, "\n")))
             ? ExitCode::as_expected
             : ExitCode::internal;
}

ExitCode separate(const SeparationCommand& command) {
  const Suite suite = load_suite(command.selection.selection());
  print_diagnostics(suite.diagnostics);
  if (!suite.diagnostics.empty()) return ExitCode::usage;
  if (suite.cases.empty()) return ExitCode::nothing_selected;
  if (command.cover) return print_cover(command, suite);
  const Separation separation = measure_separation(suite.cases);
  fmt::print(
      "{}, {} of them ({:.1f} %) with a tie\n", counted(separation.cases, "case", "cases"),
      separation.with_ties,
      100.0 * static_cast<double>(separation.with_ties) / static_cast<double>(separation.cases));
  std::size_t weak = 0;
  for (const SeparationMatrix& matrix : separation.matrices) {
    fmt::print("{}: {} alternatives, every pair told apart by at least {}\n", matrix.rule,
               matrix.alternatives.size(), counted(matrix.least(), "case", "cases"));
    if (command.full) print_matrix(matrix);
    weak += print_weak_pairs(matrix, command.least);
  }
  return weak == 0 ? ExitCode::as_expected : ExitCode::unexpected;
}

}  // namespace

void add_separation_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "separation", "Count the cases that tell each pair of a rule's alternatives apart");
  auto options = std::make_shared<SeparationCommand>();
  options->selection.add_to(*command, false);
  command->add_flag("--full", options->full, "Print the whole matrices");
  command->add_option(
      "--least", options->least,
      "List the pairs that fewer cases tell apart, and exit with 1 if there are any");
  CLI::Option* cover = command->add_flag(
      "--cover", options->cover,
      "Find the shortest list of cases that tells apart every pair that all cases tell apart, "
      "each by --least cases, and touches every ruling");
  command->add_option("-o,--output", options->list, "File for that list")->needs(cover);
  add_repeatable(*command, "--shown", options->shown,
                 "Results of which the list shows each known fault of each renderer, and a "
                 "violation of each without any; needs --cover; repeatable");
  command->callback([options, &exit] { exit = separate(*options); });
}

}  // namespace edgecase
