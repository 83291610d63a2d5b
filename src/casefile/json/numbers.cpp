// SPDX-License-Identifier: MIT
#include "casefile/json/numbers.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "casefile/json/schema.h"
#include "casefile/json/text.h"
#include "exact/numeral.h"

namespace edgecase {

namespace {

// A numeral's error has the form "fault; remedy".
void add_numeral_error(const Place& place, std::string_view what, const NumeralError& error,
                       Findings& findings) {
  const std::size_t cut = error.message.find("; ");
  const std::string remedy = cut == std::string::npos ? std::string("write a multiple of 1/65536")
                                                      : error.message.substr(cut + 2);
  findings.add(place, fmt::format("{}: {}", what, error.message.substr(0, cut)), remedy);
}

bool is_inside(double value, Float32Range range) {
  return value >= static_cast<double>(range.low) && value <= static_cast<double>(range.high);
}

std::string range_remedy(Float32Range range) {
  return fmt::format("write a number from {} to {}", exact_decimal(range.low),
                     exact_decimal(range.high));
}

}  // namespace

std::optional<Fixed> read_coordinate(const Place& place, std::string_view what, FixedRange range,
                                     Findings& findings) {
  const JsonNode& node = *place.node;
  if (node.kind != JsonKind::number && node.kind != JsonKind::string) {
    findings.add(place,
                 fmt::format("{} must be a number or a numeral, not {}", what, describe(node)),
                 "write a number like 10.5, or a string like \"21/2\" or \"10+3/256\"");
    return std::nullopt;
  }
  const auto parsed = parse_numeral(node.text);
  if (const auto* error = std::get_if<NumeralError>(&parsed)) {
    add_numeral_error(place, what, *error, findings);
    return std::nullopt;
  }
  const Fixed value = std::get<Fixed>(parsed);
  if (value < range.low || value > range.high) {
    findings.add(
        place, fmt::format("{} is {}, out of range", what, to_decimal(value)),
        fmt::format("write a number from {} to {}", to_decimal(range.low), to_decimal(range.high)));
    return std::nullopt;
  }
  if (node.text.starts_with('~'))
    findings.note(place, fmt::format("{}: {} is taken as {}", what, node.text, to_decimal(value)));
  return value;
}

std::optional<int> read_integer(const Place& place, std::string_view what, IntegerRange range,
                                Findings& findings) {
  const std::string remedy =
      range.low == range.high
          ? fmt::format("write {}", range.low)
          : fmt::format("write a whole number from {} to {}", range.low, range.high);
  if (!expect_kind(place, JsonKind::number, what, findings)) return std::nullopt;
  const auto parsed = parse_numeral(place.node->text);
  const Fixed* value = std::get_if<Fixed>(&parsed);
  if (value == nullptr || Fixed::from_integer(value->floor()) != *value) {
    findings.add(place, fmt::format("{} cannot be {}", what, place.node->text), remedy);
    return std::nullopt;
  }
  if (value->floor() < range.low || value->floor() > range.high) {
    findings.add(place, fmt::format("{} is {}, out of range", what, place.node->text), remedy);
    return std::nullopt;
  }
  return static_cast<int>(value->floor());
}

bool expect_count(const Place& place, std::string_view what, std::size_t count,
                  Findings& findings) {
  if (!expect_kind(place, JsonKind::array, what, findings)) return false;
  if (place.node->children.size() == count) return true;
  findings.add(place, fmt::format("{} has {} numbers", what, place.node->children.size()),
               fmt::format("write {}", count));
  return false;
}

std::optional<float> read_float32(const Place& place, std::string_view what, Float32Range range,
                                  Float32Kind kind, Findings& findings) {
  const JsonNode& node = *place.node;
  if (node.kind != JsonKind::number && node.kind != JsonKind::string) {
    findings.add(place,
                 fmt::format("{} must be a number or a numeral, not {}", what, describe(node)),
                 "write a number like 10.5, or a string like \"21/2\" or \"~0.1\"");
    return std::nullopt;
  }
  const std::string_view text = node.text;
  if (text.size() > kMostCharacters) {
    findings.add(place, fmt::format("{} has {} characters", what, text.size()),
                 fmt::format("write {} at most", kMostCharacters));
    return std::nullopt;
  }
  const bool nearest = text.starts_with('~');
  const auto parsed = parse_float32(nearest ? text.substr(1) : text);
  if (!parsed) {
    findings.add(place, fmt::format("{}: {} is no float32 number", what, quote(text)),
                 range_remedy(range));
    return std::nullopt;
  }
  if (!parsed->exact && !nearest && kind == Float32Kind::exact) {
    findings.add(
        place, fmt::format("{}: {} is no float32 number", what, text),
        fmt::format("write the nearest, {}, or \"~{}\"", exact_decimal(parsed->value), text));
    return std::nullopt;
  }
  if (!is_inside(parsed->wide, range)) {
    findings.add(place, fmt::format("{} is {}, out of range", what, text), range_remedy(range));
    return std::nullopt;
  }
  if (nearest)
    findings.note(place,
                  fmt::format("{}: {} is taken as {}", what, text, exact_decimal(parsed->value)));
  return parsed->value;
}

std::optional<Color> read_color(const Place& place, std::string_view what, Float32Range range,
                                Findings& findings) {
  if (!expect_kind(place, JsonKind::array, what, findings)) return std::nullopt;
  const std::size_t count = place.node->children.size();
  if (count != 3 && count != 4) {
    findings.add(place, fmt::format("{} has {} components", what, count),
                 "write [red, green, blue] or [red, green, blue, alpha]");
    return std::nullopt;
  }
  Color color{0, 0, 0, 1};
  bool sound = true;
  for (std::size_t i = 0; i < count; ++i) {
    const Place component = place.child(i);
    if (!expect_kind(component, JsonKind::number, fmt::format("a component of {}", what),
                     findings)) {
      sound = false;
      continue;
    }
    auto parsed = parse_float32(component.node->text);
    if (parsed && !is_inside(parsed->wide, range)) parsed.reset();
    if (!parsed)
      findings.add(component,
                   fmt::format("a component of {} is {}, out of range", what, component.node->text),
                   range_remedy(range));
    const std::optional<float> value = parsed ? std::optional(parsed->value) : std::nullopt;
    color[i] = value.value_or(0);
    sound = sound && value.has_value();
  }
  if (!sound) return std::nullopt;
  return color;
}

JsonPiece integer_piece(int value) {
  return json_scalar(std::to_string(value));
}

namespace {

// A colour's component: the shortest decimal whose nearest float32 it is; -0 is written as 0.
JsonPiece component_piece(float value) {
  return json_scalar(short_decimal(value + 0.0F));
}

}  // namespace

JsonPiece color_piece(const std::array<float, 4>& color) {
  std::vector<JsonPiece> components;
  const std::size_t count = color[3] == 1 ? 3 : 4;  // alpha is 1 by default
  for (std::size_t i = 0; i < count; ++i) components.push_back(component_piece(color[i]));
  return json_array(std::move(components));
}

JsonPiece exact_piece(float value) {
  return json_scalar(exact_decimal(value + 0.0F));
}

JsonPiece exact_list(std::span<const float> values) {
  std::vector<JsonPiece> items;
  for (const float value : values) items.push_back(exact_piece(value));
  return json_array(std::move(items));
}

namespace {

constexpr std::string_view kNumberSchema = R"json({
  "coordinate": {
    "description": "An exact multiple of @step from -@largest to @largest: a number (10.5), or a \
        string with a decimal (\"10.5\"), a fraction (\"21/2\"), a whole number with a fraction \
        (\"10+3/256\"), or ~ and a decimal (\"~0.1\") for the nearest multiple. A decimal whose \
        nearest double is such a multiple is taken as that (14.644210815429688).",
    "type": ["number", "string"],
    "minimum": "@least",
    "maximum": "@largest",
    "multipleOf": "@step_number",
    "maxLength": "@numeral",
    "pattern": "^(~-?(0|[1-9][0-9]{0,3})(\\.[0-9]+)?|-?(0|[1-9][0-9]{0,3})(\\.0+|\\.(5|[27]5|[16]25|[38]75|[0-9]*([05]625|[16]875|[38]125|[49]375))0*|\\.[0-9]{11,})?|~?-?(0|[1-9][0-9]*)(\\.[0-9]+)?[eE][+-]?[0-9]{1,3}|-?((0|[1-9][0-9]*)[+-])?(0|[1-9][0-9]*)/(1|2|4|8|16|32|64|128|256|512|1024|2048|4096|8192|16384|32768|65536))$"
  },
  "float32": {
    "description": "A number, or a string with a decimal, a fraction (\"21/2\"), or ~ and a \
        decimal (\"~0.1\") for the nearest float32 number.",
    "type": ["number", "string"],
    "maxLength": "@characters",
    "pattern": "^~?-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][+-]?[0-9]+)?$|^-?((0|[1-9][0-9]*)[+-])?(0|[1-9][0-9]*)/(1|2|4|8|16|32|64|128|256|512|1024|2048|4096|8192|16384|32768|65536)$"
  },
  "window_depth": {
    "description": "A float32 number from 0 to 1.",
    "$ref": "#/$defs/float32",
    "minimum": 0,
    "maximum": 1
  },
  "color": {
    "description": "[red, green, blue] or [red, green, blue, alpha], linear, each taken to the \
        nearest float32; alpha is 1 if not said. Any number of magnitude @largest_color at most: \
        what leaves 0 to 1 is clamped only by the target.",
    "type": "array",
    "minItems": 3,
    "maxItems": 4,
    "items": {
      "title": "Component",
      "description": "0 to 1, or beyond.",
      "type": "number",
      "minimum": "@least_color",
      "maximum": "@largest_color"
    }
  },
  "clear": {
    "description": "[red, green, blue] or [red, green, blue, alpha], linear, each 0 to 1 and \
        taken to the nearest float32; alpha is 1 if not said.",
    "$ref": "#/$defs/color",
    "items": {"title": "Component", "description": "0 to 1.", "minimum": 0, "maximum": 1}
  }
})json";

}  // namespace

Pieces number_schemas() {
  return schema_pieces(kNumberSchema,
                       {named("step", json_scalar(fmt::format("1/{}", Fixed::kOne))),
                        named("step_number", schema_number(1.0 / static_cast<double>(Fixed::kOne))),
                        named("largest", schema_number(Fixed::kMaxCoordinate)),
                        named("least", schema_number(-Fixed::kMaxCoordinate)),
                        named("numeral", schema_number(kMostNumeralCharacters)),
                        named("characters", schema_number(kMostCharacters)),
                        named("largest_color", schema_number(kMaxColor)),
                        named("least_color", schema_number(-kMaxColor))});
}

}  // namespace edgecase
