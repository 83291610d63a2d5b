// SPDX-License-Identifier: MIT
#include "casefile/policy_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "casefile/case_reader.h"
#include "casefile/json/fields.h"
#include "casefile/json/schema.h"
#include "casefile/json/text.h"

namespace edgecase {

namespace {

void check_alternative(const Place& place, const std::string& alternative, const KnownRule& rule,
                       Findings& findings) {
  const auto& names = rule.alternatives;
  if (std::find(names.begin(), names.end(), alternative) == names.end())
    findings.add(place, fmt::format("rule {} has no alternative {}", rule.id, quote(alternative)),
                 suggest_names(alternative, names));
}

}  // namespace

bool check_rule_id(const Place& place, std::span<const KnownRule> known, Findings& findings) {
  const std::string& id = place.node->name;
  if (!is_rule_id(id)) {
    findings.add_key(place, fmt::format("{} is no rule's id", quote(id)),
                     "write an id like line.diamond-exit; `edgecase rules` lists them");
    return false;
  }
  std::vector<std::string> ids;
  for (const KnownRule& rule : known) ids.push_back(rule.id);
  if (ids.empty() || std::find(ids.begin(), ids.end(), id) != ids.end()) return true;
  findings.add_key(place, fmt::format("there is no rule {}", quote(id)), suggest_names(id, ids));
  return false;
}

Choices read_choices(const Place& place, std::span<const KnownRule> known, Findings& findings) {
  Choices choices;
  if (!expect_kind(place, JsonKind::object, "a choice of alternatives", findings)) return choices;
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place choice = place.child(i);
    const std::string& id = choice.node->name;
    if (choice.node->duplicate) continue;
    const auto alternative =
        read_text(choice, fmt::format("the alternative of {}", quote(id)), kWordLimits, findings);
    if (!check_rule_id(choice, known, findings) || !alternative) continue;
    const auto rule = std::find_if(known.begin(), known.end(),
                                   [&](const KnownRule& candidate) { return candidate.id == id; });
    if (rule != known.end()) check_alternative(choice, *alternative, *rule, findings);
    choices[id] = *alternative;
  }
  return choices;
}

namespace {

const Keys kPolicyKeys{{"name"}, {"$schema", "why", "latitude", "rules", "surfaces"}, {}};
const Keys kSurfaceKeys{{}, {"fbo", "window"}, {}};
constexpr TextLimits kWhy{0, 10000, true};

Policy read_policy(const JsonNode& root, std::span<const KnownRule> known, Findings& findings) {
  Policy policy;
  const ObjectReader object({&root, ""}, "a policy", kPolicyKeys, findings);
  if (const auto place = object.find("$schema")) read_text(*place, "$schema", {}, findings);
  if (const auto place = object.find("why")) read_text(*place, "why", kWhy, findings);
  if (const auto place = object.find("name"))
    policy.name = read_text(*place, "a policy's name", kNameLimits, findings).value_or("");
  if (const auto place = object.find("latitude")) {
    const auto latitude = read_choice(*place, "latitude", {{"opengl", "none"}, {}}, findings);
    policy.latitude = latitude == "none" ? Latitude::none : Latitude::opengl;
  }
  if (const auto place = object.find("rules")) policy.rules = read_choices(*place, known, findings);
  if (const auto place = object.find("surfaces")) {
    const ObjectReader surfaces(*place, "surfaces", kSurfaceKeys, findings);
    for (const Surface surface : {Surface::fbo, Surface::window})
      if (const auto choices = surfaces.find(name_of(surface)))
        policy.surfaces[surface] = read_choices(*choices, known, findings);
  }
  return policy;
}

}  // namespace

LoadedPolicy load_policy(const std::filesystem::path& file, std::span<const KnownRule> known) {
  const TextFile read = read_text_file(file, kMaxFileBytes);
  if (!read.text) return {{}, {unreadable(file, read)}};
  return load_policy_text(*read.text, file, known);
}

LoadedPolicy load_policy_text(const std::string& text, const std::filesystem::path& file,
                              std::span<const KnownRule> known) {
  return load_text<Policy>(text, file, [&](const JsonNode& root, Findings& findings) {
    return read_policy(root, known, findings);
  });
}

namespace {

constexpr std::string_view kPolicySchema = R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Edgecase policy file",
  "description": "A choice of alternatives for rules: what a system does where others do \
      otherwise. A rule that is left out has the alternative that OpenGL asks for. The program's \
      own loader checks what a schema cannot: keys that stand twice.",
  "type": "object",
  "required": "@required",
  "additionalProperties": false,
  "properties": {
    "$schema": {
      "description": "Path of this schema, so that editors offer help: \
          \"../policy.schema.json\".",
      "type": "string",
      "maxLength": "@text"
    },
    "name": {
      "description": "By which reports call it.",
      "type": "string",
      "minLength": 1,
      "maxLength": "@name",
      "pattern": "^[^\\u0000-\\u001f\\u007f]*$"
    },
    "why": {
      "description": "Whose choices these are, and where they are described.",
      "type": "string",
      "maxLength": "@why"
    },
    "latitude": {
      "description": "\"opengl\": what OpenGL leaves open is permitted. \"none\": every \
          difference is a violation of the policy.",
      "enum": ["opengl", "none"],
      "default": "opengl"
    },
    "rules": {
      "description": "On all surfaces.",
      "$ref": "#/$defs/choices"
    },
    "surfaces": {
      "description": "What is otherwise on one kind of surface.",
      "type": "object",
      "additionalProperties": false,
      "properties": {
        "fbo": {"description": "A framebuffer object.", "$ref": "#/$defs/choices"},
        "window": {"description": "The window system's framebuffer.", "$ref": "#/$defs/choices"}
      }
    }
  },
  "$defs": {
    "choices": {
      "type": "object",
      "additionalProperties": false,
      "properties": {"@rules": 0}
    }
  }
})json";

JsonPiece schema_of(const KnownRule& rule) {
  return json_object({named("description", json_string(rule.title)),
                      named("enum", json_strings(rule.alternatives))});
}

}  // namespace

std::string policy_schema(std::span<const KnownRule> known) {
  Pieces rules;
  for (const KnownRule& rule : known)
    if (!rule.alternatives.empty()) rules.push_back(named(rule.id, schema_of(rule)));
  const auto most = [](const char* name, TextLimits limits) {
    return named(name, schema_number(static_cast<double>(limits.most)));
  };
  return lay_out(json_object(
      schema_pieces(kPolicySchema, {named("required", json_strings(kPolicyKeys.required)),
                                    most("text", {}), most("name", kNameLimits), most("why", kWhy),
                                    named("rules", json_object(std::move(rules)))})));
}

}  // namespace edgecase
