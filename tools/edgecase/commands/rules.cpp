// SPDX-License-Identifier: MIT
//
// edgecase rules: the catalogue, for people, as JSON or as the committed document.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "rules/all_rules.h"
#include "rules/rules_document.h"
#include "tools/edgecase/commands/commands.h"

namespace edgecase {
namespace {

void print_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Rule& rule : all_rules()) {
    nlohmann::ordered_json alternatives = nlohmann::ordered_json::array();
    for (const Alternative& a : rule.alternatives)
      alternatives.push_back(
          {{"name", a.name}, {"openness", name_of(a.openness)}, {"meaning", a.meaning}});
    nlohmann::ordered_json rulings = nlohmann::ordered_json::array();
    for (const Ruling& ruling : rule.rulings)
      rulings.push_back({{"number", ruling.number}, {"text", ruling.text}});
    list.push_back({{"id", rule.id},
                    {"title", rule.title},
                    {"spec", rule.spec},
                    {"latitude", rule.latitude},
                    {"standard", rule.standard},
                    {"alternatives", alternatives},
                    {"rulings", rulings}});
  }
  fmt::print("{}\n", list.dump(2));
}

void print_text() {
  for (const Rule& rule : all_rules()) {
    fmt::print("{}\n  {}.\n  OpenGL 4.6 core: {}. Latitude: {}.\n", rule.id, rule.title, rule.spec,
               rule.latitude);
    for (const Alternative& a : rule.alternatives)
      fmt::print("    {} {:<14} {:<8} {}\n", a.name == rule.standard ? "*" : " ", a.name,
                 name_of(a.openness), a.meaning);
    for (const Ruling& ruling : rule.rulings)
      fmt::print("  Ruling {}. {}\n", ruling.number, ruling.text);
    fmt::print("\n");
  }
  fmt::print("* the choice of policy opengl\n");
}

}  // namespace

void add_rules_command(CLI::App& app, ExitCode&) {
  CLI::App* command = app.add_subcommand("rules", "Print the rules, alternatives and rulings");
  auto json = std::make_shared<bool>(false);
  auto markdown = std::make_shared<bool>(false);
  CLI::Option* as_json = command->add_flag("--json", *json, "As JSON");
  command->add_flag("--markdown", *markdown, "As the document src/rules/RULINGS.md")
      ->excludes(as_json);
  command->callback([json, markdown] {
    if (*json)
      print_json();
    else if (*markdown)
      fmt::print("{}", rules_document());
    else
      print_text();
  });
}

}  // namespace edgecase
