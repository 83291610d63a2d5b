// SPDX-License-Identifier: MIT
//
// edgecase rules: the catalogue, for people, as JSON, as the committed document or as a book.
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <vector>

#include "rules/all_rules.h"
#include "rules/chapters.h"
#include "rules/rules_document.h"
#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/default_suite.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/book_pages.h"

namespace edgecase {
namespace {

nlohmann::ordered_json ruling_json(const Ruling& ruling) {
  const RulingSource& source = ruling.source;
  nlohmann::ordered_json json = {{"number", ruling.number},        {"text", ruling.text},
                                 {"basis", name_of(source.basis)}, {"revision", source.revision},
                                 {"clause", source.clause},        {"quotation", source.quotation},
                                 {"khronos", source.khronos},      {"es", source.es}};
  if (!source.contest.empty()) json["contest"] = source.contest;
  if (!source.withdrawn.empty()) json["withdrawn"] = source.withdrawn;
  return json;
}

struct RulesCommand {
  std::vector<std::string> ids;  // globs; none: all
  std::string book;              // a folder
  std::string suite = default_suite();
  bool json = false;
  bool markdown = false;
};

using Rules = std::vector<const Rule*>;

// The rules whose ids match one of the globs; without globs, all. Prints an error and returns
// nothing for a glob without a match.
std::optional<Rules> select_rules(const std::vector<std::string>& globs) {
  const auto matches = [](const std::string& glob, const Rule& rule) {
    return fnmatch(glob.c_str(), name_of(rule.id), 0) == 0;
  };
  for (const std::string& glob : globs)
    if (std::ranges::none_of(all_rules(), [&](const Rule& rule) { return matches(glob, rule); })) {
      print_no_rule(glob);
      return std::nullopt;
    }
  Rules selected;
  for (const Rule& rule : all_rules())
    if (globs.empty() ||
        std::ranges::any_of(globs, [&](const std::string& glob) { return matches(glob, rule); }))
      selected.push_back(&rule);
  return selected;
}

void print_json(const Rules& rules) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Rule* one : rules) {
    const Rule& rule = *one;
    nlohmann::ordered_json alternatives = nlohmann::ordered_json::array();
    for (const Alternative& a : rule.alternatives)
      alternatives.push_back(
          {{"name", a.name}, {"openness", name_of(a.openness)}, {"meaning", a.meaning}});
    nlohmann::ordered_json rulings = nlohmann::ordered_json::array();
    for (const Ruling& ruling : rule.rulings) rulings.push_back(ruling_json(ruling));
    list.push_back({{"id", name_of(rule.id)},
                    {"title", rule.title},
                    {"spec", rule.spec},
                    {"latitude", rule.latitude},
                    {"standard", rule.standard},
                    {"alternatives", alternatives},
                    {"rulings", rulings}});
  }
  fmt::print("{}\n", list.dump(2));
}

void print_text(const Rules& rules) {
  for (const Rule* one : rules) {
    const Rule& rule = *one;
    fmt::print("{}\n  {}.\n  OpenGL 4.6 core: {}. Latitude: {}.\n", name_of(rule.id), rule.title,
               rule.spec, rule.latitude);
    for (const Alternative& a : rule.alternatives)
      fmt::print("    {} {:<14} {:<8} {}\n", a.name == rule.standard ? "*" : " ", a.name,
                 name_of(a.openness), a.meaning);
    for (const Ruling& ruling : rule.rulings) {
      fmt::print("  Ruling {}. {}\n", ruling.number, ruling.text);
      for (const RulingFact& fact : facts_of(ruling))
        fmt::print("    {}: {}\n", fact.name, fact.text);
    }
    fmt::print("\n");
  }
  fmt::print("* the choice of policy opengl\n");
}

ExitCode write_book(const std::string& folder, const std::string& suite) {
  const auto book = rule_book(suite);
  if (!book) return ExitCode::usage;
  const std::filesystem::path path(folder);
  for (std::size_t i = 0; i < book->chapters.size(); ++i) {
    std::ostringstream page;
    write_book_chapter(*book, i, page);
    if (!write_file(path / (book->chapters[i].name + ".html"), page.str()))
      return ExitCode::internal;
  }
  std::ostringstream page;
  write_book_index(*book, page);
  if (!write_file(path / "index.html", page.str())) return ExitCode::internal;
  fmt::print("Rule book: {}\n", (path / "index.html").string());
  return ExitCode::as_expected;
}

ExitCode print_rules(const RulesCommand& command) {
  if (!command.book.empty()) return write_book(command.book, command.suite);
  if (command.markdown) {
    fmt::print("{}", rules_document());
    return ExitCode::as_expected;
  }
  const auto rules = select_rules(command.ids);
  if (!rules) return ExitCode::usage;
  if (command.json)
    print_json(*rules);
  else
    print_text(*rules);
  return ExitCode::as_expected;
}

}  // namespace

void add_rules_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand("rules", "Print the rules, alternatives and rulings");
  auto options = std::make_shared<RulesCommand>();
  CLI::Option* ids = command->add_option("rules", options->ids,
                                         "Ids of rules, or globs of them (default: all rules)");
  CLI::Option* as_json = command->add_flag("--json", options->json, "As JSON");
  command->add_flag("--markdown", options->markdown, "As the document src/rules/RULINGS.md")
      ->excludes(as_json)
      ->excludes(ids);
  CLI::Option* as_book =
      command
          ->add_option("--book", options->book,
                       "Folder for a book of HTML pages, with worked scenes; index.html is first")
          ->excludes(as_json)
          ->excludes("--markdown")
          ->excludes(ids);
  command->add_option("--suite", options->suite, "Folder with the cases of the book's scenes")
      ->capture_default_str()
      ->needs(as_book);
  command->callback([options, &exit] { exit = print_rules(*options); });
}

}  // namespace edgecase
