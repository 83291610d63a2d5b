// SPDX-License-Identifier: MIT
#include "casefile/scene/forms.h"

#include <fmt/format.h>

#include "casefile/scene/viewport.h"
#include "exact/numeral.h"

namespace edgecase {

namespace {

IntegerRange whole(Limits limits) {
  return {static_cast<int>(limits.low), static_cast<int>(limits.high)};
}

Float32Range float32_range(Limits limits) {
  return {static_cast<float>(limits.low), static_cast<float>(limits.high)};
}

Fixed above(double low) {
  return Fixed::from_raw(static_cast<std::int64_t>(low * Fixed::kOne) + 1);
}

}  // namespace

void read_plain(const Place& place, const char* title, Limits, Findings& findings, bool& value) {
  if (expect_kind(place, JsonKind::boolean, title, findings)) value = place.node->truth;
}

void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                int& value) {
  value = read_integer(place, title, whole(limits), findings).value_or(value);
}

void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                std::uint8_t& value) {
  value = static_cast<std::uint8_t>(
      read_integer(place, title, whole(limits), findings).value_or(int{value}));
}

void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                float& value) {
  value = read_float32(place, title, float32_range(limits), Float32Kind::exact, findings)
              .value_or(value);
}

void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                std::optional<float>& value) {
  value = read_float32(place, title, float32_range(limits), Float32Kind::exact, findings);
}

void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                Fixed& value) {
  const FixedRange range{above(limits.low), Fixed::from_integer(static_cast<int>(limits.high))};
  value = read_coordinate(place, title, range, findings).value_or(value);
}

// A short decimal if possible; otherwise a fraction, which is clearer than 10.01171875.
JsonPiece plain_piece(Fixed value) {
  constexpr std::int64_t kReadable = Fixed::kOne / 16;
  if (value.raw() % kReadable == 0) return json_scalar(to_decimal(value));
  return json_string(to_fraction(value));
}

JsonPiece reference_to(const char* definition) {
  return named("$ref", json_string(std::string("#/$defs/") + definition));
}

std::string with_limits(std::string_view description, Limits limits) {
  return fmt::format(fmt::runtime(description), fmt::arg("low", number_text(limits.low)),
                     fmt::arg("high", number_text(limits.high)));
}

void add_limits(Limits limits, bool is_size, Pieces& members) {
  members.push_back(named(is_size ? "exclusiveMinimum" : "minimum", schema_number(limits.low)));
  members.push_back(named("maximum", schema_number(limits.high)));
}

namespace {

constexpr const char* kRectangle = "rectangle";
const Keys kRectangleKeys{{"x", "y", "width", "height"}, {}, {}};

}  // namespace

std::optional<Viewport> read_rectangle(const Place& place, std::string_view title, int least_size,
                                       Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, title, kRectangleKeys, findings);
  Viewport rectangle;
  const auto read = [&](const char* key, int least, int& value) {
    if (const auto found = object.find(key))
      value = read_integer(*found, key, {least, kMaxViewportSize}, findings).value_or(value);
  };
  read("x", -kMaxViewportSize, rectangle.x);
  read("y", -kMaxViewportSize, rectangle.y);
  read("width", least_size, rectangle.width);
  read("height", least_size, rectangle.height);
  if (findings.size() != before) return std::nullopt;
  return rectangle;
}

JsonPiece rectangle_piece(const Viewport& rectangle) {
  return json_object({named("x", integer_piece(rectangle.x)),
                      named("y", integer_piece(rectangle.y)),
                      named("width", integer_piece(rectangle.width)),
                      named("height", integer_piece(rectangle.height))});
}

void Form<std::optional<Viewport>>::read(const Place& place, const char* title, Limits,
                                         Findings& findings, std::optional<Viewport>& value) {
  value = read_rectangle(place, title, 0, findings);
}

JsonPiece Form<std::optional<Viewport>>::piece(const std::optional<Viewport>& value) {
  return rectangle_piece(*value);
}

void Form<std::optional<Viewport>>::describe(Limits, Pieces& members) {
  members.push_back(reference_to(kRectangle));
}

}  // namespace edgecase
