// SPDX-License-Identifier: MIT
//
// edgecase compare: the change of each case between two results files.
#include <fmt/format.h>

#include <memory>

#include "reports/comparison_markdown.h"
#include "results/comparison.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/distinct_files.h"
#include "tools/edgecase/output/report_files.h"

namespace edgecase {
namespace {

struct CompareCommand {
  std::string before;
  std::string after;
  std::string json;
  std::string markdown;
};

bool deliver(const std::string& path, const std::string& text) {
  if (path.empty()) return true;
  if (path != "-") return write_file(path, text);
  fmt::print("{}", text);
  return true;
}

ExitCode compare(const CompareCommand& command) {
  if (!are_distinct({{"--json", command.json}, {"--markdown", command.markdown}},
                    {command.before, command.after}))
    return ExitCode::usage;
  ExitCode exit = ExitCode::as_expected;
  const auto before = load_results(command.before, exit);
  if (!before) return exit;
  const auto after = load_results(command.after, exit);
  if (!after) return exit;
  const auto compared = compare_results(*before, *after);
  if (const auto* fault = std::get_if<std::string>(&compared)) {
    print_error(*fault);
    return ExitCode::usage;
  }
  const auto& comparison = std::get<Comparison>(compared);
  // Without --markdown the comparison is printed, unless JSON goes to standard output.
  const bool print = command.markdown.empty() && command.json != "-";
  const bool wrote_json = deliver(command.json, comparison_json(comparison));
  const bool wrote_markdown =
      deliver(print ? "-" : command.markdown, comparison_markdown(comparison));
  if (!wrote_json || !wrote_markdown) return ExitCode::internal;
  return differs(comparison) ? ExitCode::unexpected : ExitCode::as_expected;
}

}  // namespace

void add_compare_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "compare", "Compare two results files, of two drivers, versions or policies, case by case");
  auto options = std::make_shared<CompareCommand>();
  command->add_option("old", options->before, "Results file of `edgecase run`")->required();
  command->add_option("new", options->after, "Results file to compare with the old one")
      ->required();
  command->add_option("--json", options->json,
                      "File for the comparison as JSON, - for standard output");
  command->add_option(
      "--markdown", options->markdown,
      "File for the comparison as Markdown, - for standard output (default: printed)");
  command->callback([options, &exit] { exit = compare(*options); });
}

}  // namespace edgecase
