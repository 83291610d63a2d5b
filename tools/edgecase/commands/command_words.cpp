// SPDX-License-Identifier: MIT
#include "tools/edgecase/commands/command_words.h"

#include <algorithm>
#include <sstream>

#include "rules/all_rules.h"
#include "run/renderers.h"

namespace edgecase {
namespace {

constexpr int kMany = CLI::detail::expected_max_vector_size;

std::vector<std::string> renderer_names() {
  std::vector<std::string> names = {"exact"};
  for (const auto* known :
       {&opengl_renderer_names(), &opengl_es_renderer_names(), &webgl_renderer_names()})
    names.insert(names.end(), known->begin(), known->end());
  return names;
}

std::vector<std::string> rule_ids() {
  std::vector<std::string> ids;
  for (const Rule& rule : all_rules()) ids.push_back(name_of(rule.id));
  return ids;
}

// The text between two brackets of a validator's description: "TEXT:{auto,never}".
std::string bracketed(const std::string& text, char open, char close) {
  const auto begin = text.find(open);
  const auto end = text.find(close, begin);
  if (begin == std::string::npos || end == std::string::npos) return "";
  return text.substr(begin + 1, end - begin - 1);
}

// The values of a list in the parser, or of one that the program knows.
std::vector<std::string> choices_of(const CLI::App& app, const CLI::Option& option,
                                    const std::string& name) {
  std::vector<std::string> choices;
  std::istringstream list(bracketed(option.get_type_name(), '{', '}'));
  for (std::string one; std::getline(list, one, ',');) choices.push_back(one);
  if (!choices.empty()) return choices;
  if (name == "--against" || name == "--with" || name == "renderers") return renderer_names();
  if (name == "--rule" || name == "--rules" || name == "rules") return rule_ids();
  if (name != "subcommand") return {};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    choices.push_back(command->get_name());
  return choices;
}

OptionWords words_of(const CLI::App& app, const CLI::Option& option) {
  OptionWords words;
  words.is_positional = !option.nonpositional();
  if (words.is_positional) words.names = {option.get_name(true)};
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  words.description = option.get_description();
  words.takes_value = option.get_type_size_max() > 0;
  words.is_required = option.get_required();
  words.is_repeatable = option.get_items_expected_max() >= kMany;
  words.default_value = option.get_default_str();
  if (words.takes_value) {
    words.range = bracketed(option.get_type_name(), '[', ']');
    words.choices = choices_of(app, option, words.names.front());
  }
  return words;
}

}  // namespace

std::vector<CommandWords> words_of(const CLI::App& app) {
  std::vector<CommandWords> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    CommandWords words{command->get_name(), command->get_description(), {}};
    for (const CLI::Option* option : command->get_options())
      words.options.push_back(words_of(app, *option));
    commands.push_back(std::move(words));
  }
  return commands;
}

}  // namespace edgecase
