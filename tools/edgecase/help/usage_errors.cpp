// SPDX-License-Identifier: MIT
#include "tools/edgecase/help/usage_errors.h"

#include <fmt/format.h>

#include <vector>

#include "casefile/json/text.h"
#include "reports/text.h"

namespace edgecase {
namespace {

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::string question(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? "" : fmt::format("did you mean {}? ", nearest);
}

// The command line that prints the help of a subcommand; without one, of the program.
std::string help_of(const CLI::App& app, const CLI::App* command) {
  if (command != nullptr) return fmt::format("{} help {}", app.get_name(), command->get_name());
  return app.get_name() + (app.get_subcommands({}).empty() ? " --help" : " help");
}

// "--agianst=exact" is "--agianst". `command`: null for the program itself.
std::string unknown_option(const CLI::App& app, const CLI::App* command, const std::string& word) {
  const std::string option = word.substr(0, word.find('='));
  // An option with a single dash and more than one letter is meant with two dashes.
  const bool is_long = option.starts_with("--") || option.size() > 2;
  const std::string written = is_long && !option.starts_with("--") ? "-" + option : option;
  const std::string asked = question(written, option_names(command == nullptr ? app : *command));
  const std::string help = help_of(app, command);
  if (command == nullptr)
    return fmt::format("there is no option {}; {}`{}` lists them", option, asked, help);
  return fmt::format("{} has no option {}; {}`{}` lists them", command->get_name(), option, asked,
                     help);
}

// The message on surplus words of the chosen subcommand or, without one, of the program.
std::string extra_words(const CLI::App& app, const CLI::App* command,
                        const std::vector<std::string>& words) {
  for (const std::string& word : words)
    if (is_option(word)) return unknown_option(app, command, word);
  if (command == nullptr && app.get_subcommands({}).empty())
    return fmt::format("there is no use for {}; `{}` says what it takes",
                       quote(clean_line(words.front())), help_of(app, command));
  if (command == nullptr)
    return fmt::format("there is no subcommand {}; {}`edgecase help` lists them",
                       quote(clean_line(words.front())), nearest_subcommand(app, words.front()));
  return fmt::format("{0} has no use for {1}; `edgecase help {0}` says what it takes",
                     command->get_name(), quote(clean_line(words.front())));
}

}  // namespace

std::string nearest_subcommand(const CLI::App& app, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return question(name, names);
}

std::string usage_error(const CLI::App& app, const CLI::Error& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App* command = chosen.empty() ? nullptr : chosen.front();
  const std::vector<std::string> extra = app.remaining(true);
  std::string text;
  if (!extra.empty())
    text = extra_words(app, command, extra);
  else
    text = fmt::format("{}; `{}` {}", error.what(), help_of(app, command),
                       command == nullptr ? "lists them" : "says what it takes");
  return one_line(app.get_name() + ": " + text) + "\n";
}

}  // namespace edgecase
