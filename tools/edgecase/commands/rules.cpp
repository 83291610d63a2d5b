// SPDX-License-Identifier: MIT
//
// edgecase rules: the catalogue, for people, as JSON, as the committed document or as a book.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "rules/all_rules.h"
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

void print_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Rule& rule : all_rules()) {
    nlohmann::ordered_json alternatives = nlohmann::ordered_json::array();
    for (const Alternative& a : rule.alternatives)
      alternatives.push_back(
          {{"name", a.name}, {"openness", name_of(a.openness)}, {"meaning", a.meaning}});
    nlohmann::ordered_json rulings = nlohmann::ordered_json::array();
    for (const Ruling& ruling : rule.rulings) rulings.push_back(ruling_json(ruling));
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

}  // namespace

void add_rules_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand("rules", "Print the rules, alternatives and rulings");
  auto book = std::make_shared<std::string>();
  auto suite = std::make_shared<std::string>(default_suite());
  auto json = std::make_shared<bool>(false);
  auto markdown = std::make_shared<bool>(false);
  CLI::Option* as_json = command->add_flag("--json", *json, "As JSON");
  command->add_flag("--markdown", *markdown, "As the document src/rules/RULINGS.md")
      ->excludes(as_json);
  CLI::Option* as_book =
      command
          ->add_option("--book", *book,
                       "Folder for a book of HTML pages, with worked scenes; index.html is first")
          ->excludes(as_json)
          ->excludes("--markdown");
  command->add_option("--suite", *suite, "Folder with the cases of the book's scenes")
      ->capture_default_str()
      ->needs(as_book);
  command->callback([json, markdown, book, suite, &exit] {
    if (!book->empty())
      exit = write_book(*book, *suite);
    else if (*json)
      print_json();
    else if (*markdown)
      fmt::print("{}", rules_document());
    else
      print_text();
  });
}

}  // namespace edgecase
