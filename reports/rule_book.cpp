// SPDX-License-Identifier: MIT
#include "reports/rule_book.h"

#include <algorithm>
#include <map>
#include <ostream>
#include <sstream>
#include <string_view>

#include "reports/nodes.h"
#include "reports/page.h"
#include "reports/text.h"

namespace edgecase {
namespace {

using Node = pugi::xml_node;

// Text between backquotes is code.
void append_prose(Node node, std::string_view text) {
  for (bool is_code = false; !text.empty(); is_code = !is_code) {
    const std::string part(text.substr(0, text.find('`')));
    text.remove_prefix(std::min(text.size(), part.size() + 1));
    if (is_code)
      add_text(node, "code", nullptr, part);
    else if (!part.empty())
      append_text(node, part);
  }
}

std::string sentence(const std::string& text) {
  return text + (text.ends_with('.') ? "" : ".");
}

std::string anchor_of(const BookRuling& ruling) {
  return fmt::format("ruling-{}", ruling.number);
}

// Ids of cases contain '/', ':' and '=', which are allowed in the fragment of an address.
std::string anchor_of(const BookScene& scene) {
  return "scene-" + scene.case_id;
}

std::string question_of(const BookScene& scene) {
  return fmt::format("Is pixel ({}, {}) drawn?", scene.picture.x, scene.picture.y);
}

// Essays consist of paragraphs, ended by blank lines, and tables, whose lines start with a space.
void add_essay(Node parent, const std::string& essay) {
  std::istringstream lines(essay);
  std::string table;
  std::string paragraph;
  const auto end_block = [&] {
    if (!paragraph.empty()) append_prose(add(parent, "p", "about"), paragraph);
    if (!table.empty()) add_text(parent, "pre", "scroll", table);
    paragraph.clear();
    table.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    const bool is_table = line.starts_with(' ');
    if (line.empty() || (is_table ? !paragraph.empty() : !table.empty())) end_block();
    if (is_table)
      table += line + "\n";
    else if (!line.empty())
      paragraph += (paragraph.empty() ? "" : " ") + line;
  }
  end_block();
}

// The alternatives as a table; the one of policy `opengl` is marked.
void add_alternatives(Node parent, const BookRule& rule) {
  Node scroll = add(parent, "div", "scroll");
  set(scroll, "tabindex", std::string("0"));
  set(scroll, "role", std::string("region"));
  set(scroll, "aria-label", "Alternatives of " + rule.id);
  Node table = add(scroll, "table", "choices");
  Node head = add(add(table, "thead"), "tr");
  for (const char* title : {"Alternative", "By OpenGL it is", "Meaning"})
    set(add_text(head, "th", nullptr, title), "scope", std::string("col"));
  Node rows = add(table, "tbody");
  for (const BookAlternative& alternative : rule.alternatives) {
    Node row = add(rows, "tr");
    Node name = add(row, "th");
    set(name, "scope", std::string("row"));
    add_text(name, "code", "chip", alternative.name);
    if (alternative.name == rule.standard) add_text(name, "p", "faint", "exact follows it");
    const bool is_illegal = alternative.openness == "illegal";
    add_text(add(row, "td"), "span", is_illegal ? "badge b-violation" : "badge b-convention",
             is_illegal                       ? "forbidden"
             : alternative.openness == "open" ? "left open"
                                              : "mandated");
    append_prose(add(row, "td"), alternative.meaning);
  }
}

// id of a rule -> file of its chapter.
std::map<std::string, std::string> files_of_rules(const RuleBook& book) {
  std::map<std::string, std::string> files;
  for (const BookChapter& chapter : book.chapters)
    for (const BookSection& section : chapter.sections)
      for (const BookRule& rule : section.rules) files[rule.id] = chapter.name + ".html";
  return files;
}

void add_rule(Node section, const RuleBook& book, const BookRule& rule) {
  Node title = add(section, "h3");
  set(title, "id", rule.id);
  add_text(title, "code", nullptr, rule.id);
  append_prose(add(section, "p", "about"), sentence(rule.title));
  Node facts = add(section, "p", "facts");
  add_text(facts, "span", nullptr, "OpenGL 4.6 core, " + rule.spec);
  Node latitude = add(section, "p", "about");
  add_text(latitude, "b", nullptr, "Latitude: ");
  append_prose(latitude, sentence(rule.latitude));
  for (const BookRuling& ruling : rule.rulings) {
    Node text = add(section, "p", "ruling");
    set(text, "id", anchor_of(ruling));
    add_text(text, "b", nullptr, fmt::format("Ruling {}. ", ruling.number));
    append_prose(text, sentence(ruling.text));
    if (ruling.facts.empty()) continue;
    Node beside = add(section, "dl", "ruling-facts");
    for (const auto& [name, fact] : ruling.facts) {
      add_text(beside, "dt", nullptr, name);
      append_prose(add(beside, "dd"), sentence(fact));
    }
  }
  if (!rule.alike.empty()) {
    Node alike = add_text(section, "p", "about", "Its alternatives are those of ");
    add_link(alike, files_of_rules(book).at(rule.alike) + "#" + rule.alike, rule.alike);
    append_text(alike, ".");
  } else if (!rule.alternatives.empty()) {
    add_alternatives(section, rule);
  }
}

void add_names(Node parent, const std::string& title, const std::vector<std::string>& names) {
  if (names.empty()) return;
  Node line = add_text(parent, "p", "named", title + " ");
  for (const std::string& name : names) {
    add_text(line, "code", "chip", name);
    append_text(line, " ");
  }
}

void add_scene(Node section, const BookScene& scene) {
  Node article = add(section, "article", "scene");
  set(article, "id", anchor_of(scene));
  Node shown = add(article, "div", "shown-row");
  add_pixel_svg(add(shown, "figure", "shown"), scene.picture);
  Node told = add(shown, "div", "told");
  add_text(told, "h3", nullptr, question_of(scene));
  Node answer = add(told, "p", "answer");
  add_text(answer, "span", scene.is_drawn ? "badge b-convention" : "badge b-not-run",
           scene.is_drawn ? "drawn" : "not drawn");
  append_text(answer, " " + sentence(scene.answer));
  Node about = add(told, "p", "about");
  add_text(about, "b", nullptr, sentence(scene.title) + " ");
  append_text(about, scene.why);
  add_text(told, "pre", "lines words", scene.words);
  if (!scene.drawn_by.empty() && !scene.left_out_by.empty()) {
    Node others = add_text(told, "p", "about", "The alternatives of ");
    add_link(others, "#" + scene.rule, scene.rule);
    append_text(others, " differ here.");
    add_names(told, "Drawing it:", scene.drawn_by);
    add_names(told, "Leaving it out:", scene.left_out_by);
  }
  add_text(add(told, "p", "faint"), "code", nullptr, scene.command);
}

// The chapters, the index first; `here` is the page's own file.
void add_navigation(Node body, const RuleBook& book, const std::string& here) {
  Node nav = add(body, "nav", "galleries");
  set(nav, "aria-label", std::string("Chapters"));
  const auto add_page = [&](const std::string& file, const std::string& title) {
    if (file == here)
      set(add_text(nav, "b", nullptr, title), "aria-current", std::string("page"));
    else
      add_link(nav, file, title);
  };
  add_page("index.html", "Contents");
  for (const BookChapter& chapter : book.chapters) add_page(chapter.name + ".html", chapter.title);
}

void add_head(Node body, const std::string& title, const std::string& about) {
  Node head = add(body, "header", "gallery-head");
  add_text(head, "p", "faint", "Edgecase rule book");
  add_text(head, "h1", nullptr, title);
  add_text(head, "p", "about", about);
}

void add_legend(Node body) {
  add_text(body, "p", "legend",
           "In the pictures y points up. Blue pixels have a fragment, and darker ones have more. "
           "The pixel in question has a frame, which is dashed if the pixel is not drawn. A dot "
           "is a covered sample, a ring one that is not covered. A thick edge owns the samples on "
           "it. A shaded shape is the region that the rule tests.");
}

void save(const std::string& title, const pugi::xml_document& document, std::ostream& out) {
  out << kBookBeforeTitle << html_of(title) << kBookBeforeBody << html_of(document)
      << kBookAfterBody;
}

void add_chapters(Node body, const RuleBook& book) {
  for (const BookChapter& chapter : book.chapters) {
    Node card = add(body, "section", "card");
    Node title = add(card, "h2");
    add_link(title, chapter.name + ".html", chapter.title);
    add_text(card, "p", "about", chapter.about);
    Node rules = add(card, "p", "named");
    for (const BookSection& section : chapter.sections)
      for (const BookRule& rule : section.rules) {
        Node link = add_link(rules, chapter.name + ".html#" + rule.id, rule.id);
        set(link, "class", std::string("mono"));
        append_text(rules, " ");
      }
  }
}

void add_scene_list(Node body, const RuleBook& book) {
  Node card = add(body, "section", "card");
  add_text(card, "h2", nullptr, "Worked scenes");
  Node list = add(card, "ol");
  for (const BookChapter& chapter : book.chapters)
    for (const BookSection& section : chapter.sections)
      for (const BookScene& scene : section.scenes) {
        Node item = add(list, "li");
        add_link(item, chapter.name + ".html#" + anchor_of(scene),
                 sentence(scene.title) + " " + question_of(scene));
      }
}

void add_ruling_list(Node body, const RuleBook& book) {
  std::map<int, std::string> places;
  for (const BookChapter& chapter : book.chapters)
    for (const BookSection& section : chapter.sections)
      for (const BookRule& rule : section.rules)
        for (const BookRuling& ruling : rule.rulings)
          places[ruling.number] = chapter.name + ".html#" + anchor_of(ruling);
  Node card = add(body, "section", "card");
  add_text(card, "h2", nullptr, "Rulings by number");
  Node line = add(card, "p", "named");
  for (const auto& [number, place] : places) {
    add_link(line, place, fmt::format("Ruling {}", number));
    append_text(line, " ");
  }
}

}  // namespace

void write_book_chapter(const RuleBook& book, std::size_t index, std::ostream& out) {
  const BookChapter& chapter = book.chapters[index];
  pugi::xml_document document;
  Node body = add(document, "main", "book");
  add_head(body, chapter.title, chapter.about);
  add_navigation(body, book, chapter.name + ".html");
  bool has_scenes = false;
  for (const BookSection& section : chapter.sections)
    has_scenes = has_scenes || !section.scenes.empty();
  if (has_scenes) add_legend(body);
  for (const BookSection& section : chapter.sections) {
    Node card = add(body, "section", "card");
    add_text(card, "h2", nullptr, section.title);
    add_essay(card, section.essay);
    for (const BookScene& scene : section.scenes) add_scene(card, scene);
    for (const BookRule& rule : section.rules) add_rule(card, book, rule);
  }
  add_text(body, "footer", "faint", book.tool);
  save(chapter.title + " - Edgecase rule book", document, out);
}

void write_book_index(const RuleBook& book, std::ostream& out) {
  pugi::xml_document document;
  Node body = add(document, "main", "book");
  add_head(body, "When is a pixel drawn?",
           "How OpenGL 4.6, core profile, decides what is drawn, rule by rule: what it says, what "
           "it leaves open, what implementations do, and how differences are judged where the text "
           "is silent. Words and pictures come from the program that judges.");
  add_navigation(body, book, "index.html");
  add_text(
      body, "p", "about",
      "A rule has alternatives. One is left open if the specification leaves the choice to the "
      "implementation. It is mandated if no other conforms. It is forbidden if it is known from "
      "faulty implementations. A ruling is our reading of the text where it is silent or vague; "
      "verdicts cite its number. Window coordinates are in pixels, y up. Pixel (i, j) has its "
      "centre at (i + 1/2, j + 1/2). e is arbitrarily small, and e^2 is smaller still.");
  add_chapters(body, book);
  add_scene_list(body, book);
  add_ruling_list(body, book);
  add_text(body, "footer", "faint", book.tool);
  save("Edgecase rule book", document, out);
}

}  // namespace edgecase
