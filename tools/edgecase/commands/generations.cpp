// SPDX-License-Identifier: MIT
//
// edgecase generations: which releases of a driver have which known fault.
#include <fmt/format.h>

#include <memory>
#include <vector>

#include "reports/generations_markdown.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/report_files.h"

namespace edgecase {
namespace {

struct GenerationsCommand {
  std::vector<std::string> files;
  std::string markdown;
};

ExitCode show_generations(const GenerationsCommand& command) {
  Generations generations;
  for (const std::string& file : command.files) {
    ExitCode exit = ExitCode::as_expected;
    const auto results = load_results(file, exit);
    if (!results) return exit;
    if (!add_generation_of(file, *results, generations)) return ExitCode::usage;
  }
  if (command.markdown.empty()) {
    fmt::print("{}", generations_text(generations));
    return ExitCode::as_expected;
  }
  const std::string text = generations_markdown(generations);
  if (command.markdown != "-")
    return write_file(command.markdown, text) ? ExitCode::as_expected : ExitCode::internal;
  fmt::print("{}", text);
  return ExitCode::as_expected;
}

}  // namespace

void add_generations_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command =
      app.add_subcommand("generations", "Show which releases of a driver have which known fault");
  auto options = std::make_shared<GenerationsCommand>();
  command->add_option("results", options->files, "Results files of whole runs, of any releases")
      ->required();
  command->add_option("--markdown", options->markdown,
                      "File for the tables in Markdown, with the reasons; - for standard output");
  command->callback([options, &exit] { exit = show_generations(*options); });
}

}  // namespace edgecase
