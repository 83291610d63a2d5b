// SPDX-License-Identifier: MIT
//
// edgecase web: a page that draws cases with the GPU of whatever browser opens it.
#include <fmt/format.h>

#include <memory>

#include "model/text.h"
#include "profile/asked_scenes.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/web_page.h"

namespace edgecase {
namespace {

struct WebCommand {
  SelectionOptions selection;
  std::string file;
  std::string show;  // one case
  bool probes = false;
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

// What `edgecase profile` asks, as cases.
CaseStore probes() {
  CaseStore cases;
  for (AskedScene& asked : asked_scenes(options_of_pages())) {
    Case one;
    one.id = std::move(asked.id);
    one.scene = std::move(asked.scene);
    cases.push_back(std::move(one));
  }
  return cases;
}

ExitCode deliver(const WebCommand& command, const std::string& page, std::size_t cases) {
  if (!write_file(command.file, page)) return ExitCode::internal;
  fmt::print("{}: {}, {} bytes; open it in any browser\n", command.file,
             counted(cases, command.probes ? "probe" : "case", command.probes ? "probes" : "cases"),
             page.size());
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
  if (command.probes) {
    const CaseStore cases = probes();
    return deliver(command,
                   web_suite_page(cases, fmt::format("Edgecase: {} probes of a profile, on this "
                                                     "device",
                                                     grouped(cases.size()))),
                   cases.size());
  }
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
  command->add_flag("--probes", options->probes,
                    "What profile asks, in place of a suite: profile --against recording:FILE "
                    "measures what the page hands back");
  command->callback([options, command, &exit] {
    for (const CLI::Option* option : command->get_options())
      if (options->probes && option->count() > 0 && option->get_name() != "--probes" &&
          option->get_name() != "--output")
        throw CLI::ExcludesError("--probes", option->get_name());
    exit = write_page(*options);
  });
}

}  // namespace edgecase
