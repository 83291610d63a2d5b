// SPDX-License-Identifier: MIT
#include "reports/gallery.h"

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <pugixml.hpp>

#include "model/text.h"
#include "reports/gallery_picture.h"
#include "reports/nodes.h"
#include "reports/page.h"
#include "reports/text.h"

namespace edgecase {
namespace {

using Node = pugi::xml_node;

std::string anchor_of(std::size_t index) {
  return fmt::format("picture-{}", index + 1);
}

bool is_web_address(const std::string& text) {
  return text.starts_with("https://") || text.starts_with("http://");
}

void add_head(Node body, const GalleryPage& page) {
  Node head = add(body, "header", "gallery-head");
  add_text(head, "p", "faint", "Edgecase gallery");
  add_text(head, "h1", nullptr, page.title);
  if (!page.about.empty()) add_text(head, "p", "about", page.about);
  Node facts = add(head, "p", "facts");
  Node policy = add(facts, "span");
  append_text(policy, "Policy ");
  add_text(policy, "code", nullptr, page.policy);
  add_text(facts, "span", nullptr, fmt::format("{} pictures", page.entries.size()));
  if (!page.renderer.empty()) add_text(facts, "span", nullptr, "Rendered by " + page.renderer);
  if (!page.sources.empty()) {
    Node sources = add(head, "p", "facts");
    add_text(sources, "span", nullptr, "Described in");
    for (const std::string& source : page.sources)
      if (is_web_address(source))
        add_link(sources, source, source);
      else
        add_text(sources, "span", nullptr, source);
  }
}

void add_navigation(Node body, const GalleryPage& page) {
  if (page.links.size() > 1) {
    Node others = add(body, "nav", "galleries");
    set(others, "aria-label", std::string("Galleries"));
    for (const GalleryLink& link : page.links)
      if (link.file.empty())
        set(add_text(others, "b", nullptr, link.title), "aria-current", std::string("page"));
      else
        add_link(others, link.file, link.title);
  }
  Node contents = add(body, "nav", "contents");
  set(contents, "aria-label", std::string("Pictures"));
  Node list = add(contents, "ol");
  for (std::size_t i = 0; i < page.entries.size(); ++i)
    add_link(add(list, "li"), "#" + anchor_of(i), page.entries[i].heading);
}

// The legality of a choice under OpenGL: the class of its badge, and its text.
std::pair<const char*, const char*> standing_of(const GalleryChoice& choice) {
  if (choice.standard.empty()) return {"badge b-agree", "as OpenGL"};
  if (choice.openness == "illegal") return {"badge b-violation", "forbidden"};
  return {"badge b-convention", "left open"};
}

void add_alternative(Node row, const std::string& name, const std::string& meaning) {
  Node cell = add(row, "td");
  add_text(cell, "code", "chip", name);
  if (!meaning.empty()) add_text(cell, "p", "faint", meaning);
}

// The numbers of the pictures that a choice determines, alone or with others.
std::vector<std::size_t> pictures_of(const GalleryPage& page, const std::string& rule) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < page.entries.size(); ++i)
    for (const auto* rules : {&page.entries[i].alone, &page.entries[i].together})
      if (std::find(rules->begin(), rules->end(), rule) != rules->end()) numbers.push_back(i);
  return numbers;
}

void add_choice(Node table, const GalleryPage& page, const GalleryChoice& choice) {
  Node row = add(table, "tr");
  Node rule = add(row, "th");
  set(rule, "scope", std::string("row"));
  add_text(rule, "code", nullptr, choice.rule);
  add_text(rule, "p", "faint", choice.title);
  add_alternative(row, choice.chosen, choice.meaning);
  if (choice.standard.empty())
    add_text(row, "td", "faint", "the same");
  else
    add_alternative(row, choice.standard, choice.standard_meaning);
  const auto [kind, words] = standing_of(choice);
  add_text(add(row, "td"), "span", kind, words);
  Node why = add(row, "td");
  if (!choice.why.empty()) add_text(why, "p", nullptr, choice.why);
  if (!choice.not_shown.empty())
    add_text(why, "p", "faint", "No picture shows it: " + choice.not_shown);
  const std::vector<std::size_t> pictures = pictures_of(page, choice.rule);
  if (pictures.empty()) return;
  Node seen = add_text(why, "p", "faint", "Seen in ");
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (i > 0) append_text(seen, ", ");
    add_link(seen, "#" + anchor_of(pictures[i]), fmt::format("picture {}", pictures[i] + 1));
  }
}

void add_choices(Node body, const GalleryPage& page) {
  Node section = add(body, "section", "card");
  add_text(section, "h2", nullptr, "What the policy chooses");
  if (page.choices.empty()) {
    add_text(section, "p", nullptr, "Nothing: it is OpenGL's own.");
    return;
  }
  Node scroll = add(section, "div", "scroll");
  set(scroll, "tabindex", std::string("0"));
  set(scroll, "role", std::string("region"));
  set(scroll, "aria-label", std::string("Choices"));
  Node table = add(scroll, "table", "choices");
  Node head = add(add(table, "thead"), "tr");
  for (const char* title : {"Rule", "Here", "OpenGL", "By OpenGL it is", "Why"})
    set(add_text(head, "th", nullptr, title), "scope", std::string("col"));
  Node rows = add(table, "tbody");
  for (const GalleryChoice& choice : page.choices) add_choice(rows, page, choice);
}

// "3 pixels have another colour, by up to 9 of 255, 1 more is drawn another number of times";
// empty where nothing differs.
std::string describe(const GalleryDifference& difference) {
  std::string words;
  if (difference.colors > 0)
    words = fmt::format("{} another colour, by up to {} of 255",
                        counted(difference.colors, "pixel has", "pixels have"), difference.largest);
  if (difference.counts == 0) return words;
  if (words.empty())
    return counted(difference.counts, "pixel is", "pixels are") + " drawn another number of times";
  return words + ", " + counted(difference.counts, "more is", "more are") +
         " drawn another number of times";
}

std::string joined(const std::vector<std::string>& names, const char* last) {
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i)
    words += (i == 0 ? "" : i + 1 == names.size() ? fmt::format(" {} ", last) : ", ") + names[i];
  return words;
}

Node add_figure(Node parent, const GalleryEntry& entry, const GalleryImage& image,
                const GalleryDifference& difference, const std::string& title,
                const std::string& words) {
  Node figure = add(parent, "figure", "shown");
  Node caption = add(figure, "figcaption");
  add_text(caption, "b", nullptr, title);
  if (!words.empty()) add_text(caption, "span", "faint", words);
  add_gallery_picture(figure, entry, image, difference, xml_text(title + ". " + words));
  return caption;
}

void add_rendered(Node parent, const GalleryEntry& entry, const std::string& renderer) {
  if (entry.rendered.pixels.empty()) {
    Node figure = add(parent, "figure", "shown missing");
    Node caption = add(figure, "figcaption");
    add_text(caption, "b", nullptr, renderer);
    add_text(caption, "span", "badge b-not-run", "not-run");
    add_text(figure, "p", "faint", entry.failure);
    return;
  }
  const GalleryDifference difference = difference_of(entry.rendered, entry.opengl);
  const std::string words = describe(difference);
  Node caption = add_figure(parent, entry, entry.rendered, difference, renderer,
                            words.empty() ? "the same pixels as exact" : words);
  const std::string verdict = name_of(entry.verdict);
  add_text(caption, "span", ("badge b-" + verdict).c_str(), verdict);
}

void add_entry(Node body, const GalleryPage& page, std::size_t index) {
  const GalleryEntry& entry = page.entries[index];
  Node article = add(body, "article", "card");
  set(article, "id", anchor_of(index));
  add_text(article, "h2", nullptr, fmt::format("{}. {}", index + 1, entry.heading));
  if (!entry.text.empty()) add_text(article, "p", "about", entry.text);
  Node facts = add(article, "p", "facts");
  add_text(facts, "code", nullptr, entry.case_id);
  if (!entry.origin.empty()) add_text(facts, "span", nullptr, entry.origin);
  for (const std::string& choice : entry.otherwise) {
    Node otherwise = add_text(facts, "span", nullptr, "this picture alone with ");
    add_text(otherwise, "code", "chip", choice);
  }
  Node shown = add(article, "div", "shown-row");
  const GalleryDifference difference = difference_of(entry.policy, entry.opengl);
  add_figure(shown, entry, entry.policy, difference, page.policy, describe(difference));
  add_figure(shown, entry, entry.opengl, difference_of(entry.opengl, entry.opengl),
             "OpenGL, exactly", "");
  add_rendered(shown, entry, page.renderer.substr(0, page.renderer.find(" (")));
  add_text(article, "p", "sentence", describe_contrast(entry));
}

std::string body_of(const GalleryPage& page) {
  pugi::xml_document document;
  Node body = document.append_child("main");
  add_head(body, page);
  add_navigation(body, page);
  add_choices(body, page);
  add_text(body, "p", "legend",
           "A dashed line on white surrounds pixels that differ in colour from OpenGL's exact "
           "picture, a thin dotted one those that differ by no more than 1 of 255; a ring marks "
           "pixels that are drawn another number of times. Dots and thin lines are points and "
           "outlines of what is drawn.");
  for (std::size_t i = 0; i < page.entries.size(); ++i) add_entry(body, page, i);
  add_text(body, "footer", "faint", page.tool);
  return html_of(document);
}

}  // namespace

GalleryDifference difference_of(const GalleryImage& a, const GalleryImage& b) {
  const std::size_t pixels = std::min(a.pixels.size(), b.pixels.size()) / 4;
  GalleryDifference difference;
  difference.colored.resize(pixels);
  difference.slightly.resize(pixels);
  difference.counted.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    int largest = 0;
    for (std::size_t byte = 4 * i; byte < 4 * i + 4; ++byte)
      largest = std::max(largest, std::abs(int{a.pixels[byte]} - int{b.pixels[byte]}));
    difference.colored[i] = largest > 1;
    difference.slightly[i] = largest == 1;
    difference.counted[i] =
        largest == 0 && i < a.hits.size() && i < b.hits.size() && a.hits[i] != b.hits[i];
    difference.colors += largest > 0 ? 1U : 0U;
    difference.counts += difference.counted[i] ? 1U : 0U;
    difference.largest = std::max(difference.largest, largest);
  }
  return difference;
}

std::string describe_contrast(const GalleryEntry& entry) {
  const std::string words = describe(difference_of(entry.policy, entry.opengl));
  if (words.empty()) return "The policy and OpenGL draw the same here.";
  if (entry.alone.size() == 1)
    return fmt::format("{}: by {} alone. With it as OpenGL has it, the two pictures are the same.",
                       words, entry.alone.front());
  if (!entry.alone.empty())
    return fmt::format(
        "{}. With {} as OpenGL has it, each by itself, the two pictures are the "
        "same.",
        words, joined(entry.alone, "or"));
  return fmt::format(
      "{}. The two pictures are the same with {} as OpenGL has them, and not with {}.", words,
      joined(entry.together, "and"), entry.together.size() > 3 ? "any three of these" : "fewer");
}

void write_gallery(const GalleryPage& page, std::ostream& out) {
  out << kGalleryBeforeTitle << html_of(page.title) << kGalleryBeforeBody << body_of(page)
      << kGalleryAfterBody;
}

}  // namespace edgecase
