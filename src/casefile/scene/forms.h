// SPDX-License-Identifier: MIT
//
// Forms: how the values of model/scene_fields.h stand in a case file. One form of a type reads it,
// writes it, and describes it in the schema, for all rows with such a member:
//
//   names, flags, numbers   by the row's limits and descriptions alone
//   nouns of such           objects with a key for each row; Form<std::optional<Noun>>
//   anything else           a specialization, which is defined beside its noun
//
// Rows that are marked by_hand, and members without a form, depend on more than themselves: they
// are read and written beside their noun.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/json/numbers.h"
#include "casefile/json/schema.h"
#include "model/scene_fields.h"

namespace edgecase {

// Of a value with a form:
//   read      reads it, or adds a finding and leaves it; `title` names it in messages
//   piece     writes a value that differs from the default
//   describe  adds the members of its schema that say which JSON it is
// The primary template, for types without a form.
template <class Value>
struct Form {};

template <class Value>
inline constexpr bool kIsOptional = false;
template <class Value>
inline constexpr bool kIsOptional<std::optional<Value>> = true;

template <class Value>
concept HasForm = requires(const Value& value) {
  Form<Value>::piece(value);
};

// Calls `visit(field, part)`, as for_each_row does, with the rows that have a form.
template <HasFields Noun, class Visit>
constexpr void for_each_form(Visit&& visit) {
  for_each_row<Noun>([&](const auto& field, const auto& part) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    if constexpr (HasForm<Value>) {
      if (!field.is_by_hand) visit(field, part);
    }
  });
}

// ------------------------------------------------------------------------ names, flags and numbers

// A form that is one JSON scalar. Written objects have these first.
template <class Value>
inline constexpr bool kIsPlain =
    HasNames<Value> || std::is_same_v<Value, bool> || std::is_same_v<Value, int> ||
    std::is_same_v<Value, std::uint8_t> || std::is_same_v<Value, float> ||
    std::is_same_v<Value, std::optional<float>> || std::is_same_v<Value, Fixed>;

// Reads one. If the value is refused, a finding is added and `value` is unchanged.
template <HasNames Enum>
bool read_plain(const Place& place, const char* title, Limits, Findings& findings, Enum& value) {
  return read_enum(place, title, {names_of<Enum>(), {}}, findings, value);
}
void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                bool& value);
void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                int& value);
void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                std::uint8_t& value);
void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                float& value);
void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                std::optional<float>& value);
// A width or size, which must exceed the lower limit.
void read_plain(const Place& place, const char* title, Limits limits, Findings& findings,
                Fixed& value);

template <HasNames Enum>
JsonPiece plain_piece(Enum value) {
  return json_string(name_of(value));
}
inline JsonPiece plain_piece(bool value) {
  return json_scalar(value ? "true" : "false");
}
inline JsonPiece plain_piece(int value) {
  return integer_piece(value);
}
inline JsonPiece plain_piece(float value) {
  return exact_piece(value);
}
inline JsonPiece plain_piece(std::optional<float> value) {
  return exact_piece(*value);
}
JsonPiece plain_piece(Fixed value);

// The definition to which a value refers in the schema; null: its type is written in place.
template <class Value>
inline constexpr const char* kDefinition = nullptr;
template <>
inline constexpr const char* kDefinition<CompareFunction> = "compare_function";
template <>
inline constexpr const char* kDefinition<StencilOperation> = "stencil_operation";
template <>
inline constexpr const char* kDefinition<BlendFactor> = "blend_factor";
template <>
inline constexpr const char* kDefinition<float> = "float32";
template <>
inline constexpr const char* kDefinition<std::optional<float>> = "float32";
template <>
inline constexpr const char* kDefinition<Fixed> = "coordinate";

JsonPiece reference_to(const char* definition);

// "minimum" and "maximum"; for a width or size, "exclusiveMinimum".
void add_limits(Limits limits, bool is_size, Pieces& members);

template <class Value>
requires kIsPlain<Value>
struct Form<Value> {
  static void read(const Place& place, const char* title, Limits limits, Findings& findings,
                   Value& value) {
    read_plain(place, title, limits, findings, value);
  }
  static JsonPiece piece(const Value& value) { return plain_piece(value); }
  static void describe(Limits limits, Pieces& members) {
    if constexpr (kDefinition<Value> != nullptr)
      members.push_back(reference_to(kDefinition<Value>));
    else if constexpr (HasNames<Value>)
      members.push_back(named("enum", schema_names<Value>()));
    else
      members.push_back(
          named("type", json_string(std::is_same_v<Value, bool> ? "boolean" : "integer")));
    if constexpr (!HasNames<Value> && !std::is_same_v<Value, bool>)
      add_limits(limits, std::is_same_v<Value, Fixed>, members);
  }
};

// ------------------------------------------------------------------------------- objects with rows

template <HasFields Noun>
std::vector<std::string> keys_of() {
  std::vector<std::string> keys;
  for_each_form<Noun>([&](const auto& field, const auto&) { keys.emplace_back(field.case_key); });
  return keys;
}

// The keys of all rows, with a form or not, that a case file must have.
template <HasFields Noun>
std::vector<std::string> required_keys() {
  std::vector<std::string> keys;
  for_each_field<Noun>([&](const auto& field) {
    if (field.is_required) keys.emplace_back(field.case_key);
  });
  return keys;
}

// Reads all rows that an object has.
template <HasFields Noun>
void read_fields(const ObjectReader& object, Findings& findings, Noun& noun) {
  for_each_form<Noun>([&](const auto& field, const auto& part) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    if (const auto place = object.find(field.case_key))
      Form<Value>::read(*place, field.title, field.limits, findings, part(noun).*field.member);
  });
}

// The keys of an object of which none is required.
template <HasFields Noun>
const Keys& object_keys() {
  static const Keys keys{{}, keys_of<Noun>(), {}};
  return keys;
}

// Reads such an object; `title` names it in messages.
template <HasFields Noun>
Noun read_object(const Place& place, std::string_view title, Findings& findings) {
  Noun noun;
  read_fields(ObjectReader(place, title, object_keys<Noun>(), findings), findings, noun);
  return noun;
}

// The members of the rows whose value differs from `standard`.
template <HasFields Noun>
void add_fields(const Noun& noun, Pieces& members, const Noun& standard = {}) {
  for (const bool plain : {true, false})
    for_each_form<Noun>([&](const auto& field, const auto& part) {
      using Value = typename std::remove_cvref_t<decltype(field)>::Type;
      const auto& value = part(noun).*field.member;
      if (kIsPlain<Value> == plain && value != part(standard).*field.member)
        members.push_back(named(field.case_key, Form<Value>::piece(value)));
    });
}

// An object of those members.
template <HasFields Noun>
JsonPiece object_piece(const Noun& noun) {
  Pieces members;
  add_fields(noun, members);
  return json_object(std::move(members));
}

// A description with its limits filled in.
std::string with_limits(std::string_view description, Limits limits);

// Whether each row with a scalar that is read from the list has a description.
template <HasFields Noun>
constexpr bool are_described() {
  bool all = true;
  for_each_form<Noun>([&](const auto& field, const auto&) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    all = all && (!kIsPlain<Value> || field.description != nullptr);
  });
  return all;
}

// One property for each row with a form: its label, description, JSON type and default. Rows by
// hand are left out unless they have a description, others without one have their definition say
// all.
template <HasFields Noun>
Pieces field_schemas() {
  static_assert(are_described<Noun>(), "a key of case files has no description in scene_fields.h");
  static const Noun standard;
  Pieces properties;
  for_each_row<Noun>([&](const auto& field, const auto& part) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    if constexpr (HasForm<Value>) {
      const bool is_described = field.description != nullptr;
      if (field.is_by_hand && !is_described) return;
      Pieces members;
      if (is_described)
        members = {named("title", json_string(field.label)),
                   named("description", json_string(with_limits(field.description, field.limits)))};
      Form<Value>::describe(field.limits, members);
      if constexpr (!kIsOptional<Value>)
        if (is_described && !field.is_required)
          members.push_back(named("default", Form<Value>::piece(part(standard).*field.member)));
      properties.push_back(named(field.case_key, json_object(std::move(members))));
    }
  });
  return properties;
}

template <HasFields Noun>
struct Form<std::optional<Noun>> {
  static void read(const Place& place, const char* title, Limits, Findings& findings,
                   std::optional<Noun>& value) {
    value = read_object<Noun>(place, title, findings);
  }
  static JsonPiece piece(const std::optional<Noun>& value) { return object_piece(*value); }
  static void describe(Limits, Pieces& members) {
    members.push_back(named("type", json_string("object")));
    members.push_back(named("additionalProperties", json_scalar("false")));
    members.push_back(named("properties", json_object(field_schemas<Noun>())));
  }
};

// ------------------------------------------------------------------------------------- other forms

// {"x", "y", "width", "height"} in whole pixels: corners from -16384 to 16384, sizes to 16384.
// `least_size` is 0 of a box that may drop everything.
std::optional<Viewport> read_rectangle(const Place& place, std::string_view title, int least_size,
                                       Findings& findings);
JsonPiece rectangle_piece(const Viewport& rectangle);

// Forms of their own, defined beside their nouns.
template <>
struct Form<std::optional<Viewport>> {
  static void read(const Place& place, const char* title, Limits limits, Findings& findings,
                   std::optional<Viewport>& value);
  static JsonPiece piece(const std::optional<Viewport>& value);
  static void describe(Limits limits, Pieces& members);
};
template <>
struct Form<DepthTest> {
  static void read(const Place& place, const char* title, Limits limits, Findings& findings,
                   DepthTest& value);
  static JsonPiece piece(const DepthTest& value);
  static void describe(Limits limits, Pieces& members);
};
template <>
struct Form<std::optional<StencilTest>> {
  static void read(const Place& place, const char* title, Limits limits, Findings& findings,
                   std::optional<StencilTest>& value);
  static JsonPiece piece(const std::optional<StencilTest>& value);
  static void describe(Limits limits, Pieces& members);
};
template <>
struct Form<std::optional<Blending>> {
  static void read(const Place& place, const char* title, Limits limits, Findings& findings,
                   std::optional<Blending>& value);
  static JsonPiece piece(const std::optional<Blending>& value);
  static void describe(Limits limits, Pieces& members);
};
using ColorMask = std::array<bool, 4>;
template <>
struct Form<ColorMask> {
  static void read(const Place& place, const char* title, Limits limits, Findings& findings,
                   ColorMask& value);
  static JsonPiece piece(const ColorMask& value);
  static void describe(Limits limits, Pieces& members);
};

}  // namespace edgecase
