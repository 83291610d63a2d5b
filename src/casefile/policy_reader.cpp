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

// What load_text calls: `read` with the rules that there are.
template <class Read>
auto by(Read read, std::span<const KnownRule> known) {
  return [read, known](const JsonNode& root, Findings& findings) {
    return read(root, known, findings);
  };
}

template <class Value, class Read>
Loaded<Value> load_file(const std::filesystem::path& file, Read read) {
  const TextFile text = read_text_file(file, kMaxFileBytes);
  if (!text.text) return {{}, {unreadable(file, text)}};
  return load_text<Value>(*text.text, file, read);
}

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
  return load_file<Policy>(file, by(read_policy, known));
}

LoadedPolicy load_policy_text(const std::string& text, const std::filesystem::path& file,
                              std::span<const KnownRule> known) {
  return load_text<Policy>(text, file, by(read_policy, known));
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

namespace {

const Keys kGalleryKeys{
    {"title", "policy", "pictures"}, {"$schema", "about", "sources", "choices", "not_shown"}, {}};
const Keys kPictureKeys{{"case", "heading"}, {"text", "rules"}, {}};
constexpr TextLimits kWords{1, 2000};
constexpr TextLimits kSource{1, 500};
constexpr TextLimits kCaseId{1, 500};
constexpr std::size_t kMostPictures = 100;

std::string text_of(const ObjectReader& object, const char* key, const std::string& what,
                    TextLimits limits, Findings& findings) {
  const auto place = object.find(key);
  return place ? read_text(*place, what, limits, findings).value_or("") : "";
}

std::map<std::string, std::string> read_explanations(const Place& place,
                                                     std::span<const KnownRule> known,
                                                     Findings& findings) {
  std::map<std::string, std::string> explanations;
  if (!expect_kind(place, JsonKind::object, "explanations of rules", findings)) return explanations;
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place item = place.child(i);
    const auto text = read_text(item, "the explanation of a rule", kWords, findings);
    if (check_rule_id(item, known, findings) && text && !item.node->duplicate)
      explanations[item.node->name] = *text;
  }
  return explanations;
}

std::vector<std::string> read_sources(const Place& place, Findings& findings) {
  std::vector<std::string> sources;
  if (!expect_kind(place, JsonKind::array, "sources", findings)) return sources;
  for (std::size_t i = 0; i < place.node->children.size(); ++i)
    if (auto source = read_text(place.child(i), "a source", kSource, findings))
      sources.push_back(std::move(*source));
  return sources;
}

GalleryPicture read_picture(const Place& place, std::span<const KnownRule> known,
                            Findings& findings) {
  GalleryPicture picture;
  const ObjectReader object(place, "a picture", kPictureKeys, findings);
  picture.case_id = text_of(object, "case", "a case's id", kCaseId, findings);
  picture.heading = text_of(object, "heading", "a heading", kWordLimits, findings);
  picture.text = text_of(object, "text", "a picture's text", kWords, findings);
  if (const auto rules = object.find("rules"))
    picture.rules = read_choices(*rules, known, findings);
  return picture;
}

std::vector<GalleryPicture> read_pictures(const Place& place, std::span<const KnownRule> known,
                                          Findings& findings) {
  std::vector<GalleryPicture> pictures;
  if (!expect_kind(place, JsonKind::array, "pictures", findings)) return pictures;
  const std::size_t count = place.node->children.size();
  if (count == 0 || count > kMostPictures) {
    findings.add(place, fmt::format("a gallery cannot have {} pictures", count),
                 fmt::format("give 1 to {}", kMostPictures));
    return pictures;
  }
  for (std::size_t i = 0; i < count; ++i)
    pictures.push_back(read_picture(place.child(i), known, findings));
  return pictures;
}

Gallery read_gallery(const JsonNode& root, std::span<const KnownRule> known, Findings& findings) {
  Gallery gallery;
  const ObjectReader object({&root, ""}, "a gallery", kGalleryKeys, findings);
  text_of(object, "$schema", "$schema", {}, findings);
  gallery.title = text_of(object, "title", "a gallery's title", kWordLimits, findings);
  gallery.about = text_of(object, "about", "about", kWords, findings);
  gallery.policy = text_of(object, "policy", "a policy's name", kNameLimits, findings);
  if (const auto place = object.find("sources")) gallery.sources = read_sources(*place, findings);
  if (const auto place = object.find("choices"))
    gallery.choices = read_explanations(*place, known, findings);
  if (const auto place = object.find("not_shown"))
    gallery.not_shown = read_explanations(*place, known, findings);
  if (const auto place = object.find("pictures"))
    gallery.pictures = read_pictures(*place, known, findings);
  return gallery;
}

}  // namespace

LoadedGallery load_gallery(const std::filesystem::path& file, std::span<const KnownRule> known) {
  return load_file<Gallery>(file, by(read_gallery, known));
}

LoadedGallery load_gallery_text(const std::string& text, const std::filesystem::path& file,
                                std::span<const KnownRule> known) {
  return load_text<Gallery>(text, file, by(read_gallery, known));
}

namespace {

constexpr std::string_view kGallerySchema = R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Edgecase gallery file",
  "description": "The cases by which a policy is shown, with the words beside their pictures. \
      The program's own loader checks what a schema cannot: keys that stand twice, whether there \
      are such rules, alternatives, cases and such a policy, and whether words are about what \
      the policy chooses.",
  "type": "object",
  "required": "@required",
  "additionalProperties": false,
  "properties": {
    "$schema": {
      "description": "Path of this schema, so that editors offer help: \
          \"../gallery.schema.json\".",
      "type": "string",
      "maxLength": "@text"
    },
    "title": {"description": "The page's heading.", "$ref": "#/$defs/line"},
    "about": {
      "description": "What system this is, in a few sentences.",
      "$ref": "#/$defs/words"
    },
    "policy": {
      "description": "Name of a file in policies/, without its suffix.",
      "type": "string",
      "minLength": 1,
      "maxLength": "@policy"
    },
    "sources": {
      "description": "Where the system is described; addresses become links.",
      "type": "array",
      "items": {"type": "string", "minLength": 1, "maxLength": "@source"}
    },
    "choices": {
      "description": "Why the system has what the policy chooses, rule by rule.",
      "$ref": "#/$defs/words_on_rules"
    },
    "not_shown": {
      "description": "Why no picture shows a choice.",
      "$ref": "#/$defs/words_on_rules"
    },
    "pictures": {
      "description": "The pictures, in their order.",
      "type": "array",
      "minItems": 1,
      "maxItems": "@pictures",
      "items": {
        "type": "object",
        "required": "@required_of_pictures",
        "additionalProperties": false,
        "properties": {
          "case": {
            "description": "Id of a case, as `edgecase run --list` prints it.",
            "type": "string",
            "minLength": 1,
            "maxLength": "@case"
          },
          "heading": {"description": "What the picture shows.", "$ref": "#/$defs/line"},
          "text": {"description": "What to look at.", "$ref": "#/$defs/words"},
          "rules": {
            "description": "What this picture alone has otherwise than the policy: alternatives \
                by rule.",
            "type": "object",
            "propertyNames": {"$ref": "#/$defs/rule"},
            "additionalProperties": {
              "type": "string",
              "minLength": 1,
              "maxLength": "@alternative"
            }
          }
        }
      }
    }
  },
  "$defs": {
    "line": {
      "type": "string",
      "minLength": 1,
      "maxLength": "@line",
      "pattern": "^[^\\u0000-\\u001f\\u007f]*$"
    },
    "words": {
      "type": "string",
      "minLength": 1,
      "maxLength": "@words",
      "pattern": "^[^\\u0000-\\u001f\\u007f]*$"
    },
    "rule": {"type": "string", "pattern": "^[a-z0-9]+(\\.[a-z0-9-]+)+$"},
    "words_on_rules": {
      "type": "object",
      "propertyNames": {"$ref": "#/$defs/rule"},
      "additionalProperties": {"$ref": "#/$defs/words"}
    }
  }
})json";

}  // namespace

std::string gallery_schema() {
  const auto most = [](const char* name, TextLimits limits) {
    return named(name, schema_number(static_cast<double>(limits.most)));
  };
  return lay_out(json_object(schema_pieces(
      kGallerySchema,
      {named("required", json_strings(kGalleryKeys.required)),
       named("required_of_pictures", json_strings(kPictureKeys.required)),
       named("pictures", schema_number(kMostPictures)), most("text", {}), most("line", kWordLimits),
       most("words", kWords), most("source", kSource), most("case", kCaseId),
       most("policy", kNameLimits), most("alternative", kWordLimits)})));
}

}  // namespace edgecase
