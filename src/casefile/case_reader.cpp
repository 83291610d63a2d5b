// SPDX-License-Identifier: MIT
#include "casefile/case_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "casefile/json/text.h"
#include "casefile/mesh/transform.h"
#include "casefile/scene/forms.h"
#include "casefile/sweep/variants.h"

namespace edgecase {
namespace {

const Keys kCaseKeys{{"title", "rules", "target", "draws"},
                     {"$schema", "why", "spec", "origin", "tags", "invariant", "details",
                      "textures", "transform", "expect", "sweep", "variants"},
                     {}};

bool is_word(std::string_view word, bool dashes) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (dashes && c == '-');
  });
}

void read_text_into(const ObjectReader& object, const char* name, TextLimits limits,
                    Findings& findings, std::string& value) {
  if (const auto place = object.find(name))
    value = read_text(*place, name, limits, findings).value_or("");
}

// Reads an array of distinct strings; `check` is called for each of them.
template <class Check>
std::vector<std::string> read_strings(const Place& place, const char* what, Findings& findings,
                                      const Check& check) {
  std::vector<std::string> words;
  if (!expect_kind(place, JsonKind::array, what, findings)) return words;
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place item = place.child(i);
    const auto word = read_text(item, fmt::format("an item of {}", what), kWordLimits, findings);
    if (!word) continue;
    if (std::find(words.begin(), words.end(), *word) != words.end())
      findings.add(item, fmt::format("{} stands twice in {}", quote(*word), what), "keep one");
    else
      check(item, *word);
    words.push_back(*word);
  }
  return words;
}

std::vector<std::string> read_rules(const Place& place, std::span<const std::string> known,
                                    Findings& findings) {
  if (place.node->kind == JsonKind::array && place.node->children.empty())
    findings.add(place, "a case names no rule", "name the rule that the case is about");
  return read_strings(place, "rules", findings, [&](const Place& item, const std::string& word) {
    if (!is_rule_id(word)) {
      findings.add(item, fmt::format("{} is no rule's id", quote(word)),
                   "write an id like line.diamond-exit; `edgecase rules` lists them");
    } else if (!known.empty() && std::find(known.begin(), known.end(), word) == known.end()) {
      findings.add(item, fmt::format("there is no rule {}", quote(word)),
                   suggest_names(word, known));
    }
  });
}

std::vector<std::string> read_tags(const Place& place, Findings& findings) {
  return read_strings(place, "tags", findings, [&](const Place& item, const std::string& word) {
    if (!is_word(word, true))
      findings.add(item, fmt::format("{} is no tag", quote(word)),
                   "use lower-case letters, digits and dashes");
  });
}

bool is_link(std::string_view text) {
  for (const std::string_view scheme : {"https://", "http://"})
    if (text.starts_with(scheme))
      return text.size() > scheme.size() && text.find(' ') == std::string_view::npos;
  return false;
}

void read_origin(const Place& place, Findings& findings, std::string& origin) {
  const std::optional<std::string> text = read_text(place, "origin", {}, findings);
  if (!text) return;
  origin = *text;
  if (!is_link(origin))
    findings.add(place, fmt::format("{} is no link", quote(origin)),
                 "write a link that starts with https:// or http://");
}

void read_case_texts(const ObjectReader& object, std::span<const std::string> known_rules,
                     Findings& findings, Case& result) {
  std::string schema;
  read_text_into(object, "$schema", {}, findings, schema);
  read_text_into(object, "title", kWordLimits, findings, result.title);
  read_text_into(object, "why", {0, 10000, true}, findings, result.why);
  read_text_into(object, "spec", {}, findings, result.spec);
  if (const auto rules = object.find("rules"))
    result.rules = read_rules(*rules, known_rules, findings);
  if (const auto origin = object.find("origin")) read_origin(*origin, findings, result.origin);
  if (const auto invariant = object.find("invariant"))
    if (expect_kind(*invariant, JsonKind::boolean, "invariant", findings))
      result.invariant = invariant->node->truth;
  if (const auto tags = object.find("tags")) result.tags = read_tags(*tags, findings);
}

Details read_details(const Place& place, Findings& findings) {
  Names names;
  for_each_form<Details>(
      [&](const auto& field, const auto&) { names.allowed.push_back(field.case_key); });
  const std::vector<std::string> given =
      read_strings(place, "details", findings, [&](const Place& item, const std::string&) {
        read_choice(item, "a detail", names, findings);
      });
  if (place.node->kind == JsonKind::array && place.node->children.empty())
    findings.add(place, "details are empty",
                 "name one of " + join_names(names.allowed) + ", or remove the key");
  Details details;
  for_each_form<Details>([&](const auto& field, const auto&) {
    details.*field.member = std::find(given.begin(), given.end(), field.case_key) != given.end();
  });
  return details;
}

// Refuses features that are only supported with one sample per pixel so far.
void refuse_of_several_samples(const ObjectReader& object, const CaseFields& fields,
                               Findings& findings) {
  if (fields.target.target.samples <= 1) return;
  if (const auto textures = object.find("textures"))
    findings.add_key(*textures, "textures with several samples are not supported yet",
                     "remove them, or write \"samples\": 1 into the target");
  if (fields.details.derivatives)
    findings.add(*object.find("details"), "derivatives with several samples are not supported yet",
                 "remove \"derivatives\", or write \"samples\": 1 into the target");
}

void read_scene(const ObjectReader& object, MeshShelf& meshes, TextureShelf& shelf,
                Findings& findings, CaseFields& fields) {
  if (const auto place = object.find("target")) fields.target = read_target(*place, findings);
  if (const auto place = object.find("details")) fields.details = read_details(*place, findings);
  refuse_of_several_samples(object, fields, findings);
  std::optional<TextureList> textures = TextureList{};
  if (const auto place = object.find("textures")) textures = read_textures(*place, shelf, findings);
  const std::size_t before = findings.size();
  std::optional<Transform> transform;
  if (const auto place = object.find("transform")) transform = read_transform(*place, findings);
  if (findings.size() != before) transform.reset();
  fields.draws_place = object.find("draws");
  if (!fields.draws_place) return;
  const DrawContext context{fields.target, transform ? &*transform : nullptr, textures, meshes};
  fields.draws = read_draws(*fields.draws_place, context, findings);
  fields.details.texture =
      std::any_of(fields.draws.begin(), fields.draws.end(),
                  [](const DrawFields& draw) { return draw.draw.texture.has_value(); });
  fields.textures = std::move(textures).value_or(TextureList{});
  if (fields.target.y_down && findings.empty())
    turn_y_up(fields.target, fields.draws, *fields.draws_place, findings);
}

}  // namespace

const Keys& case_keys() {
  return kCaseKeys;
}

bool is_rule_id(std::string_view name) {
  std::size_t dot = name.find('.');
  if (dot == std::string_view::npos || !is_word(name.substr(0, dot), false)) return false;
  while (dot != std::string_view::npos) {
    const std::size_t start = dot + 1;
    dot = name.find('.', start);
    const std::size_t end = dot == std::string_view::npos ? name.size() : dot;
    if (!is_word(name.substr(start, end - start), true)) return false;
  }
  return true;
}

CaseFields read_case_fields(const JsonNode& root, std::span<const std::string> known_rules,
                            MeshShelf& meshes, TextureShelf& textures, Findings& findings) {
  CaseFields fields;
  const ObjectReader object({&root, ""}, "a case", kCaseKeys, findings);
  read_case_texts(object, known_rules, findings, fields.words);
  if (const auto place = object.find("expect"))
    expect_kind(*place, JsonKind::array, "expect", findings);
  read_scene(object, meshes, textures, findings, fields);
  return fields;
}

}  // namespace edgecase
