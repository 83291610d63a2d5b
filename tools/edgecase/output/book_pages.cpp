// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/book_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/chapters.h"
#include "suite/expectation_check.h"
#include "suite/selection.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/pixel_words.h"
#include "tools/edgecase/output/worked_scenes.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

// The cases of all worked scenes by id; prints errors and returns nothing if one cannot be loaded.
std::optional<std::map<std::string, Case>> load_cases(const fs::path& suite) {
  Selection selection;
  for (const WorkedScene& scene : worked_scenes()) {
    const std::string id(scene.case_id);
    selection.paths.push_back(suite / (id.substr(0, id.find(':')) + ".json"));
    selection.filters.push_back(id);
  }
  const Suite loaded = load_suite(selection);
  print_diagnostics(loaded.diagnostics);
  std::map<std::string, Case> cases;
  for (const Case& one : loaded.cases) cases[one.id] = one;
  bool is_complete = loaded.diagnostics.empty();
  for (const WorkedScene& scene : worked_scenes()) {
    if (!is_complete || cases.contains(std::string(scene.case_id))) continue;
    print_error(
        fmt::format("{} has no case {}; the rule book needs the suite that this program "
                    "came with",
                    suite.string(), scene.case_id));
    is_complete = false;
  }
  if (!is_complete) return std::nullopt;
  return cases;
}

// "0, 1 and 3".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

std::string answer_of(const std::vector<PixelExplanation>& decisions) {
  std::vector<std::string> drawn;
  bool has_samples = false;
  for (const PixelExplanation& why : decisions) {
    has_samples = has_samples || why.sample >= 0;
    if (why.covered) drawn.push_back(std::to_string(why.sample < 0 ? why.primitive : why.sample));
  }
  const char* many = drawn.size() == 1 ? "" : "s";
  if (has_samples)
    return fmt::format("{} of {} samples: {}", drawn.size(), decisions.size(), listed(drawn));
  if (drawn.empty()) return "By no primitive";
  return fmt::format("By primitive{} {}", many, listed(drawn));
}

// Finds the alternatives of the scene's rule that draw the pixel.
void compare_alternatives(const Scene& scene, const Rule& rule, BookScene& told) {
  const auto index = static_cast<std::size_t>(told.picture.y * told.picture.width + told.picture.x);
  for (const Alternative& alternative : rule.alternatives) {
    Policy policy;
    policy.rules[name_of(rule.id)] = alternative.name;
    const bool is_drawn = hits_of(rasterize(scene, policy))[index] > 0;
    (is_drawn ? told.drawn_by : told.left_out_by).push_back(alternative.name);
  }
}

// The command that prints a scene's text.
std::string command_of(const WorkedScene& scene) {
  const std::string id(scene.case_id);
  const std::string file = id.substr(0, id.find(':'));
  return fmt::format("edgecase explain cases/{}.json{} --pixel {},{}", file,
                     id == file ? "" : fmt::format(" --filter \"{}\"", id), scene.x, scene.y);
}

BookScene book_scene(const WorkedScene& worked, const Case& one) {
  const Policy policy;
  const Pixel pixel{worked.x, worked.y};
  const auto decisions = explain_pixel(one.scene, policy, pixel.x, pixel.y);
  BookScene scene;
  scene.case_id = one.id;
  scene.title = one.title;
  scene.why = one.why;
  scene.answer = answer_of(decisions);
  scene.is_drawn = std::ranges::any_of(decisions, &PixelExplanation::covered);
  scene.words = pixel_words(one.scene, policy, pixel);
  scene.command = command_of(worked);
  scene.picture = pixel_picture(one, policy, pixel);
  scene.rule = name_of(worked.rule);
  compare_alternatives(one.scene, rule_of(worked.rule), scene);
  return scene;
}

// The first rule of the catalogue with the same alternatives.
RuleId first_alike(const Rule& rule) {
  const auto same = [](const Alternative& a, const Alternative& b) {
    return a.name == b.name && a.openness == b.openness && a.meaning == b.meaning;
  };
  for (const Rule& earlier : all_rules())
    if (earlier.standard == rule.standard &&
        std::ranges::equal(earlier.alternatives, rule.alternatives, same))
      return earlier.id;
  return rule.id;
}

BookRule book_rule(const Rule& rule) {
  BookRule told{name_of(rule.id), rule.title, rule.spec, rule.latitude, rule.standard, {}, "", {}};
  for (const Alternative& a : rule.alternatives)
    told.alternatives.push_back({a.name, name_of(a.openness), a.meaning});
  for (const Ruling& ruling : rule.rulings) {
    told.rulings.push_back({ruling.number, ruling.text, {}});
    for (RulingFact& fact : facts_of(ruling))
      told.rulings.back().facts.emplace_back(std::move(fact.name), std::move(fact.text));
  }
  if (const RuleId first = first_alike(rule); first != rule.id && !rule.alternatives.empty())
    told.alike = name_of(first);
  return told;
}

BookSection book_section(const Section& section, const std::map<std::string, Case>& cases) {
  BookSection told;
  told.title = section.title;
  told.essay = essay_of(section);
  for (const RuleId id : section.rules) told.rules.push_back(book_rule(rule_of(id)));
  for (const WorkedScene& scene : worked_scenes())
    if (std::ranges::find(section.rules, scene.rule) != section.rules.end())
      told.scenes.push_back(book_scene(scene, cases.at(std::string(scene.case_id))));
  return told;
}

}  // namespace

std::optional<RuleBook> rule_book(const fs::path& suite) {
  const auto cases = load_cases(suite);
  if (!cases) return std::nullopt;
  RuleBook book;
  book.tool = kToolName;
  for (const Chapter& chapter : chapters()) {
    BookChapter told{
        std::string(chapter.name), std::string(chapter.title), std::string(chapter.about), {}};
    for (const Section& section : chapter.sections)
      told.sections.push_back(book_section(section, *cases));
    book.chapters.push_back(std::move(told));
  }
  return book;
}

}  // namespace edgecase
