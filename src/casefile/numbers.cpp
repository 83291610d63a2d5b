// SPDX-License-Identifier: MIT
#include "casefile/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <string>
#include <variant>

#include "exact/numeral.h"

namespace edgecase {
namespace {

// A numeral's error is "what is wrong; how to put it right".
void add_numeral_error(const Place& place, std::string_view what, const NumeralError& error,
                       Findings& findings) {
  const std::size_t cut = error.message.find("; ");
  const std::string remedy = cut == std::string::npos ? std::string("write a multiple of 1/65536")
                                                      : error.message.substr(cut + 2);
  findings.add(place, fmt::format("{}: {}", what, error.message.substr(0, cut)), remedy);
}

// The float32 nearest to a JSON number inside [0, 1], or none when it lies outside.
std::optional<float> nearest_unit_float(const std::string& text) {
  const char* end = text.data() + text.size();
  double wide = 0;
  if (std::from_chars(text.data(), end, wide).ec != std::errc()) return std::nullopt;
  if (!(wide >= 0 && wide <= 1)) return std::nullopt;
  float value = 0;
  // Below the smallest float32 nothing but zero is near.
  if (std::from_chars(text.data(), end, value).ec != std::errc()) value = 0;
  return value + 0.0F;  // -0 becomes 0
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

std::optional<Color> read_color(const Place& place, std::string_view what, Findings& findings) {
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
    const std::optional<float> value = nearest_unit_float(component.node->text);
    if (!value) {
      findings.add(component,
                   fmt::format("a component of {} is {}, out of range", what, component.node->text),
                   "write a number from 0 to 1");
    }
    color[i] = value.value_or(0);
    sound = sound && value.has_value();
  }
  if (!sound) return std::nullopt;
  return color;
}

}  // namespace edgecase
