// SPDX-License-Identifier: MIT
//
// edgecase web: a page that draws cases with the GPU of whatever browser opens it.
#include <fmt/format.h>

#include <memory>

#include "model/text.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/web_page.h"

namespace edgecase {
namespace {

struct WebCommand {
  SelectionOptions selection;
  std::string file;
  std::string show;  // one case
};

// Without a selection, the core: a page is for devices that are slow, and people who wait.
Suite suite_of(const WebCommand& command) {
  SelectionOptions options = command.selection;
  const bool selects = !options.paths.empty() || !options.filters.empty() ||
                       !options.tags.empty() || !options.suite.empty();
  if (!command.show.empty()) options.paths = {command.show};
  if (command.show.empty() && !selects) options.suite = "core";
  return load_suite(options.selection());
}

ExitCode deliver(const WebCommand& command, const std::string& page, std::size_t cases) {
  if (!write_file(command.file, page)) return ExitCode::internal;
  fmt::print("{}: {}, {} bytes; open it in any browser\n", command.file,
             counted(cases, "case", "cases"), page.size());
  return ExitCode::as_expected;
}

std::optional<std::string> page_of(const WebCommand& command, const Suite& suite) {
  if (command.show.empty())
    return web_suite_page(suite.cases, fmt::format("Edgecase: {} on this device",
                                                   counted(suite.cases.size(), "case", "cases")));
  if (suite.cases.size() == 1) return web_show_page(suite.cases[0]);
  print_error(
      fmt::format("--live shows one case, and \"{}\" are {}; `edgecase run {} --list` "
                  "prints their ids",
                  command.show, counted(suite.cases.size(), "case", "cases"), command.show));
  return std::nullopt;
}

ExitCode write_page(const WebCommand& command) {
  const Suite suite = suite_of(command);
  print_diagnostics(suite.diagnostics);
  const ExitCode exit = suite.diagnostics.empty() ? ExitCode::as_expected : ExitCode::usage;
  if (suite.cases.empty()) {
    if (exit != ExitCode::as_expected) return exit;
    print_nothing_selected();
    return ExitCode::nothing_selected;
  }
  const auto page = page_of(command, suite);
  if (!page) return ExitCode::usage;
  return worse(exit, deliver(command, *page, suite.cases.size()));
}

}  // namespace

void add_web_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand(
      "web", "Write a page that draws cases in any browser and hands back a recording");
  auto options = std::make_shared<WebCommand>();
  options->selection.add_to(*command, true);
  command->add_option("-o,--output", options->file, "The page to write")->required();
  command->add_option("--live", options->show,
                      "One case, to be shown beside exact with a magnifier, in place of a suite");
  command->callback([options, &exit] { exit = write_page(*options); });
}

}  // namespace edgecase
