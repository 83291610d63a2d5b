// SPDX-License-Identifier: MIT
#include "rules/rules_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "rules/all_rules.h"

namespace edgecase {
namespace {

constexpr std::string_view kHead =
    R"(<!-- SPDX-License-Identifier: MIT -->
<!-- Generated. To renew: build/release/bin/edgecase rules --markdown > src/rules/RULINGS.md -->

# Rules and rulings

How Edgecase reads OpenGL 4.6, core profile. A **rule** is one statement of the specification; a
**ruling** says how we read it where it is silent or loose, and verdicts cite its number. This page is
printed by `edgecase rules --markdown` from the very entries that the program judges by.

The **basis** of a ruling is *normative* where a sentence of the text says so and nothing speaks against
it: what breaks it is a violation. It is *contested* where the letter forbids what the text elsewhere, an
open issue of the specification or the Khronos conformance tests accept: what breaks it is contested. A
ruling that fell is *withdrawn*; its number is not used again.

Window coordinates have y up. An alternative is *open* where the specification leaves the choice to
the implementation, *mandated* where it is the only one that conforms, and *illegal* where it is
known from faulty implementations. The one in bold is the choice of policy `opengl`.
)";

// Escapes characters that have a meaning in Markdown.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("*<|`\\").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string sentence(std::string_view text) {
  return escaped(text) + (text.ends_with('.') ? "" : ".");
}

// GitHub's anchor of a heading that is a rule's id: dots are dropped.
std::string link_to(const Rule& rule) {
  std::string anchor = name_of(rule.id);
  std::erase(anchor, '.');
  return fmt::format("[`{}`](#{})", name_of(rule.id), anchor);
}

// By number, which is unique.
std::map<int, std::pair<const Ruling*, const Rule*>> numbered_rulings() {
  std::map<int, std::pair<const Ruling*, const Rule*>> rulings;
  for (const Rule& rule : all_rules())
    for (const Ruling& ruling : rule.rulings) rulings[ruling.number] = {&ruling, &rule};
  return rulings;
}

std::string rulings_section() {
  std::string text = "\n## Rulings\n";
  for (const auto& [number, entry] : numbered_rulings()) {
    text += fmt::format("\n### Ruling {}\n\nRule {}.\n\n{}\n", number, link_to(*entry.second),
                        sentence(entry.first->text));
    const char* separator = "\n";
    for (const RulingFact& fact : facts_of(*entry.first)) {
      text += fmt::format("{}- **{}.** {}\n", separator, fact.name, sentence(fact.text));
      separator = "";
    }
  }
  return text;
}

bool same_alternatives(const Rule& a, const Rule& b) {
  return a.standard == b.standard &&
         std::ranges::equal(
             a.alternatives, b.alternatives, [](const Alternative& x, const Alternative& y) {
               return x.name == y.name && x.openness == y.openness && x.meaning == y.meaning;
             });
}

// The first rule of the catalogue with the same alternatives, possibly the rule itself.
const Rule& first_with_alternatives_of(const Rule& rule) {
  for (const Rule& earlier : all_rules())
    if (same_alternatives(earlier, rule)) return earlier;
  return rule;
}

std::string alternatives_of(const Rule& rule) {
  if (rule.alternatives.empty()) return "";
  const Rule& first = first_with_alternatives_of(rule);
  if (&first != &rule)
    return fmt::format("\nAlternatives: those of {}, with the same one chosen.\n", link_to(first));
  std::string text = "\n| alternative | | meaning |\n|---|---|---|\n";
  for (const Alternative& alternative : rule.alternatives) {
    const bool standard = alternative.name == rule.standard;
    text += fmt::format("| {0}`{1}`{0} | {2} | {3} |\n", standard ? "**" : "", alternative.name,
                        name_of(alternative.openness), escaped(alternative.meaning));
  }
  return text;
}

std::string cited_rulings(const Rule& rule) {
  std::string text;
  for (const Ruling& ruling : rule.rulings)
    text += fmt::format("{}[ruling {}](#ruling-{})", text.empty() ? " Judged by " : ", ",
                        ruling.number, ruling.number);
  return text.empty() ? "" : text + ".";
}

std::string rule_section(const Rule& rule) {
  return fmt::format("\n### {}\n\n{} Section {}.{}\n\nLatitude: {}\n{}", name_of(rule.id),
                     sentence(rule.title), escaped(rule.spec), cited_rulings(rule),
                     sentence(rule.latitude), alternatives_of(rule));
}

}  // namespace

std::string rules_document() {
  std::string text(kHead);
  text += rulings_section();
  text += "\n## Rules\n";
  for (const Rule& rule : all_rules()) text += rule_section(rule);
  return text;
}

}  // namespace edgecase
