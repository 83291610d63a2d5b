// SPDX-License-Identifier: MIT
//
// edgecase help: the help of the program, or of one subcommand.
#include <fmt/format.h>

#include <memory>

#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/help/usage_errors.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

ExitCode print_help(const CLI::App& app, const std::string& name) {
  const auto formatter = app.get_formatter();
  if (name.empty()) {
    fmt::print("{}", formatter->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal));
    return ExitCode::as_expected;
  }
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() != name) continue;
    fmt::print("{}", formatter->make_help(command, app.get_name() + " " + name,
                                          CLI::AppFormatMode::Normal));
    return ExitCode::as_expected;
  }
  print_error(fmt::format("there is no subcommand \"{}\"; {}`edgecase help` lists them", name,
                          nearest_subcommand(app, name)));
  return ExitCode::usage;
}

}  // namespace

void add_help_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand("help", "Print the help of a subcommand");
  auto name = std::make_shared<std::string>();
  command->add_option("subcommand", *name, "Name of a subcommand (default: list all of them)");
  command->callback([&app, name, &exit] { exit = print_help(app, *name); });
}

}  // namespace edgecase
