// SPDX-License-Identifier: MIT
#include "casefile/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "casefile/json/numbers.h"
#include "casefile/json/schema.h"
#include "casefile/json/text.h"
#include "exact/numeral.h"

namespace edgecase {

namespace {

const Keys kRangeKeys{{"from", "to", "step"}, {}, {}};
constexpr FixedRange kSwept{Fixed::from_integer(-kMaxSwept), Fixed::from_integer(kMaxSwept)};

// A name like "triangle_strip": no numeral starts with a letter.
bool is_word(std::string_view text) {
  return !text.empty() && text[0] >= 'a' && text[0] <= 'z' &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
         });
}

AxisValue number_value(Fixed amount) {
  AxisValue value{to_decimal(amount), {}, amount};
  value.node.kind = JsonKind::number;
  value.node.text = value.name;
  return value;
}

// The value of a float32 number that is too fine or too large for any coordinate.
std::optional<float> beyond_coordinates(std::string_view text) {
  const auto number = parse_float32(text);
  if (!number || !number->exact || !(std::fabs(number->value) <= kMaxColor)) return std::nullopt;
  const auto numeral = parse_numeral(text);
  const Fixed* fixed = std::get_if<Fixed>(&numeral);
  const bool fits = fixed != nullptr && *fixed >= kSwept.low && *fixed <= kSwept.high;
  return fits ? std::nullopt : std::optional(number->value);
}

AxisValue float_value(float number) {
  AxisValue value{short_decimal(number), {}, {}};
  value.node.kind = JsonKind::number;
  value.node.text = exact_decimal(number);
  return value;
}

std::string indexed(std::size_t index) {
  return fmt::format("#{}", index);
}

std::optional<AxisValue> read_axis_value(const Place& place, std::size_t index, bool numbers_only,
                                         Findings& findings) {
  const JsonNode& node = *place.node;
  if (!numbers_only) {
    if (node.kind == JsonKind::boolean) return AxisValue{node.truth ? "true" : "false", node, {}};
    if (node.kind == JsonKind::array) return AxisValue{indexed(index), node, {}};
    if (node.kind == JsonKind::string && is_word(node.text)) return AxisValue{node.text, node, {}};
    if (node.kind != JsonKind::number && node.kind != JsonKind::string) {
      findings.add(place, fmt::format("an axis has no use for {}", describe(node)),
                   "write a number, a numeral, a word, true or false, or a colour");
      return std::nullopt;
    }
    if (const auto number = beyond_coordinates(node.text)) return float_value(*number);
  }
  const auto amount = read_coordinate(place, "a value of an axis", kSwept, findings);
  if (!amount) return std::nullopt;
  return number_value(*amount);
}

bool equal(const JsonNode& a, const JsonNode& b) {
  return a.kind == b.kind && a.name == b.name && a.text == b.text && a.truth == b.truth &&
         std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(),
                    equal);
}

void append_new(const Place& place, AxisValue value, std::vector<AxisValue>& values,
                Findings& findings) {
  for (const AxisValue& other : values)
    if (equal(other.node, value.node)) {
      findings.add(place, fmt::format("the value {} stands twice", other.name), "keep one");
      break;
    }
  values.push_back(std::move(value));
}

// Checks that it is an array of 1 to kMaxCases items.
bool is_sound_list(const Place& place, const char* what, Findings& findings) {
  if (!expect_kind(place, JsonKind::array, what, findings)) return false;
  const std::size_t count = place.node->children.size();
  if (count > 0 && count <= kMaxCases) return true;
  findings.add(place, fmt::format("an axis has {} values", count),
               fmt::format("write 1 to {}", kMaxCases));
  return false;
}

std::optional<Fixed> read_end(const ObjectReader& object, const char* name, Findings& findings) {
  const auto place = object.find(name);
  return place ? read_coordinate(*place, name, kSwept, findings) : std::nullopt;
}

std::string shown(const JsonNode& node) {
  if (node.kind == JsonKind::boolean) return node.truth ? "true" : "false";
  if (const auto number = beyond_coordinates(node.text)) return short_decimal(*number);
  const auto numeral = parse_numeral(node.text);
  if (const auto* value = std::get_if<Fixed>(&numeral)) return to_decimal(*value);
  return node.text;
}

}  // namespace

std::vector<AxisValue> read_values(const Place& place, bool numbers_only, Findings& findings) {
  std::vector<AxisValue> values;
  if (!is_sound_list(place, "values", findings)) return values;
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place item = place.child(i);
    auto value = read_axis_value(item, i, numbers_only, findings);
    if (value) append_new(item, std::move(*value), values, findings);
  }
  return values;
}

std::vector<AxisValue> read_range(const Place& place, Findings& findings) {
  std::vector<AxisValue> values;
  const ObjectReader object(place, "a range", kRangeKeys, findings);
  const auto from = read_end(object, "from", findings);
  const auto to = read_end(object, "to", findings);
  const auto step = read_end(object, "step", findings);
  if (!from || !to || !step) return values;
  if (*step <= Fixed()) {
    findings.add(*object.find("step"), fmt::format("a step is {}", to_decimal(*step)),
                 "write a step above 0");
    return values;
  }
  if (*to < *from) {
    findings.add(place,
                 fmt::format("a range runs from {} down to {}", to_decimal(*from), to_decimal(*to)),
                 "write the smaller end first");
    return values;
  }
  const auto count = static_cast<std::size_t>((*to - *from).raw() / step->raw()) + 1;
  if (count > kMaxCases) {
    findings.add(place, fmt::format("a range has {} values", count),
                 fmt::format("use a larger step: {} values at most", kMaxCases));
    return values;
  }
  for (Fixed at = *from; at <= *to; at = at + *step) values.push_back(number_value(at));
  return values;
}

std::vector<AxisValue> read_points(const Place& place, Findings& findings) {
  std::vector<AxisValue> values;
  if (!is_sound_list(place, "points", findings)) return values;
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place item = place.child(i);
    const JsonKind kind = item.node->kind;
    if (kind == JsonKind::array || kind == JsonKind::object)
      append_new(item, {indexed(i), *item.node, {}}, values, findings);
    else
      findings.add(item, fmt::format("a point cannot be {}", describe(*item.node)),
                   "write [x, y], or a whole vertex");
  }
  return values;
}

std::optional<std::size_t> read_value_of(const Place& place, const SweepAxis& axis,
                                         Findings& findings) {
  const std::string name = shown(*place.node);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < axis.values.size(); ++i) {
    if (axis.values[i].name == name) return i;
    constexpr std::size_t kShown = 20;
    if (i < kShown) names.push_back(axis.values[i].name);
  }
  if (names.size() < axis.values.size()) names.push_back("...");
  findings.add(
      place, fmt::format("{} is no value of the axis {}", describe(*place.node), quote(axis.name)),
      fmt::format("write one of {}", join_names(names)));
  return std::nullopt;
}

namespace {

constexpr std::string_view kSweepSchema = R"json({
  "swept": {
    "description": "A number that a sweep runs through: an exact multiple of 1/65536 from \
        -@swept to @swept, written like a coordinate.",
    "type": ["number", "string"],
    "if": {"type": "string"},
    "then": {"maxLength": "@numeral", "pattern": "^~?-?[0-9][0-9+/.eE-]*$"},
    "else": {"minimum": "@least_swept", "maximum": "@swept", "multipleOf": "@step"}
  },
  "set_number": {
    "description": "A number that a sweep sets: an exact multiple of 1/65536 from -@swept to \
        @swept, written like a coordinate, or a float32 number of magnitude @color at most.",
    "type": ["number", "string"],
    "if": {"type": "string"},
    "then": {"maxLength": "@characters", "pattern": "^~?-?[0-9][0-9+/.eE-]*$"},
    "else": {"minimum": "@least_color", "maximum": "@color"}
  },
  "set_list": {
    "description": "A list that a sweep sets: a colour, vertices, a texture's size or colours, \
        wraps, texture coordinates, gradients.",
    "type": "array",
    "minItems": 1,
    "items": {"type": ["number", "string", "array", "object"]}
  },
  "axis_name": {
    "description": "A letter from a to z first, then a to z, 0 to 9 and dashes; not \"variant\".",
    "type": "string",
    "pattern": "^[a-z][a-z0-9-]*$",
    "not": {"const": "variant"}
  },
  "value_name": {
    "description": "A value of an axis: a number, a word, true or false, or \"#\" and the index \
        (from 0) of a point or colour.",
    "type": ["number", "string", "boolean"]
  },
  "pointers": {
    "description": "JSON pointers into the target, the textures, the draws or the transform. \
        /draws/I/vertices/J/x (y, z, w) is a coordinate in whatever form the vertex is written, \
        and s and t are its texture coordinates; everything else is addressed as in the file.",
    "type": "array",
    "minItems": 1,
    "uniqueItems": true,
    "items": {
      "title": "Pointer",
      "description": "For example /draws/0/vertices/0/x or /draws/0/state/line_width.",
      "type": "string",
      "pattern": "^/(target|textures|draws|transform)(/([^/~]|~[01])*)+$"
    }
  },
  "axis": {
    "title": "Axis",
    "description": "Some values, and what takes them.",
    "type": "object",
    "additionalProperties": false,
    "allOf": [
      {"oneOf": [{"required": ["set"]}, {"required": ["add_to"]}]},
      {"oneOf": [{"required": ["values"]}, {"required": ["range"]}, {"required": ["points"]}]},
      {
        "if": {"required": ["points"]},
        "then": {
          "required": ["set"],
          "properties": {
            "set": {
              "description": "Points go to vertices.",
              "items": {"pattern": "^/draws/[^/]+/vertices/[^/]+$"}
            }
          }
        }
      },
      {
        "if": {"required": ["add_to"]},
        "then": {
          "properties": {
            "values": {
              "description": "Only numbers can be added.",
              "items": {"$ref": "#/$defs/swept"}
            }
          }
        }
      }
    ],
    "properties": {
      "set": {
        "title": "Set",
        "description": "Where the values are put; optional keys need not be there.",
        "$ref": "#/$defs/pointers"
      },
      "add_to": {
        "title": "Add to",
        "description": "Numbers of the file to which the values are added.",
        "$ref": "#/$defs/pointers"
      },
      "values": {
        "title": "Values",
        "description": "1 to @cases numbers, numerals, words, true, false, colours or other \
            lists, none twice. Numbers that are set may also be float32 numbers that no \
            coordinate can be.",
        "type": "array",
        "minItems": 1,
        "maxItems": "@cases",
        "uniqueItems": true,
        "items": {
          "title": "Value",
          "description": "What is set or added.",
          "if": {"anyOf": [{"type": "boolean"}, {"type": "string", "pattern": "^[a-z]"}]},
          "then": {"if": {"type": "string"}, "then": {"pattern": "^[a-z][a-z0-9_-]*$"}},
          "else": {
            "if": {"type": "array"},
            "then": {"$ref": "#/$defs/set_list"},
            "else": {"$ref": "#/$defs/set_number"}
          }
        }
      },
      "range": {
        "title": "Range",
        "description": "from, from + step, and so on, as long as it is not above to; @cases \
            values at most.",
        "type": "object",
        "required": ["from", "to", "step"],
        "additionalProperties": false,
        "properties": {
          "from": {"title": "From", "description": "The first value.", "$ref": "#/$defs/swept"},
          "to": {
            "title": "To",
            "description": "The end, included where a step meets it.",
            "$ref": "#/$defs/swept"
          },
          "step": {
            "title": "Step",
            "description": "Above 0.",
            "$ref": "#/$defs/swept",
            "exclusiveMinimum": 0
          }
        }
      },
      "points": {
        "title": "Points",
        "description": "Positions, which leave a vertex its colour, or whole vertices; named by \
            their index: #0, #1.",
        "type": "array",
        "minItems": 1,
        "maxItems": "@cases",
        "uniqueItems": true,
        "items": {"$ref": "#/$defs/vertex"}
      },
      "base": {
        "title": "Base",
        "description": "The value of the base case, the first if not said.",
        "$ref": "#/$defs/value_name"
      },
      "zip": {
        "title": "Zip",
        "description": "Name of a group: its axes run together, and have equally many values.",
        "type": "string",
        "maxLength": "@name",
        "pattern": "^[a-z][a-z0-9-]*$"
      }
    }
  }
})json";

}  // namespace

Pieces sweep_schemas() {
  return schema_pieces(
      kSweepSchema,
      {named("name", schema_number(kNameLimits.most)), named("swept", schema_number(kMaxSwept)),
       named("least_swept", schema_number(-kMaxSwept)),
       named("step", schema_number(1.0 / static_cast<double>(Fixed::kOne))),
       named("numeral", schema_number(kMostNumeralCharacters)),
       named("characters", schema_number(kMostCharacters)),
       named("color", schema_number(kMaxColor)), named("least_color", schema_number(-kMaxColor)),
       named("cases", schema_number(kMaxCases))});
}

}  // namespace edgecase
