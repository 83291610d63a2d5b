// SPDX-License-Identifier: MIT
//
// Fields with a key of their own in a case file, as a name, a flag or a number: they are read and
// written by the lists of model/scene_fields.h. Other forms, and fields that the lists mark
// by_hand, are read and written beside their noun.
#pragma once

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

template <class Value>
inline constexpr bool kIsPlain =
    HasNames<Value> || std::is_same_v<Value, bool> || std::is_same_v<Value, int> ||
    std::is_same_v<Value, std::uint8_t> || std::is_same_v<Value, float> ||
    std::is_same_v<Value, std::optional<float>> || std::is_same_v<Value, Fixed>;

// Calls `visit` with each plain field of a noun.
template <HasFields Noun, class Visit>
constexpr void for_each_plain_field(Visit&& visit) {
  for_each_field<Noun>([&](const auto& field) {
    using Value = std::remove_cvref_t<decltype(std::declval<Noun&>().*field.member)>;
    if constexpr (kIsPlain<Value>) {
      if (!field.is_by_hand) visit(field);
    }
  });
}

template <HasFields Noun>
std::vector<std::string> plain_keys() {
  std::vector<std::string> keys;
  for_each_plain_field<Noun>([&](const auto& field) { keys.emplace_back(field.case_key); });
  return keys;
}

// The keys of all fields, plain or not, that a case file must have.
template <HasFields Noun>
std::vector<std::string> required_keys() {
  std::vector<std::string> keys;
  for_each_field<Noun>([&](const auto& field) {
    if (field.is_required) keys.emplace_back(field.case_key);
  });
  return keys;
}

// Reads a plain field. If the value is refused, a finding is added and `value` is unchanged.
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

// Reads all plain fields that an object has.
template <HasFields Noun>
void read_fields(const ObjectReader& object, Findings& findings, Noun& noun) {
  for_each_plain_field<Noun>([&](const auto& field) {
    if (const auto place = object.find(field.case_key))
      read_plain(*place, field.title, field.limits, findings, noun.*field.member);
  });
}

// The keys of an object with only plain fields, none of them required.
template <HasFields Noun>
const Keys& plain_object_keys() {
  static const Keys keys{{}, plain_keys<Noun>(), {}};
  return keys;
}

// Reads such an object; `what` names it in messages.
template <HasFields Noun>
Noun read_plain_object(const Place& place, std::string_view what, Findings& findings) {
  Noun noun;
  read_fields(ObjectReader(place, what, plain_object_keys<Noun>(), findings), findings, noun);
  return noun;
}

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

// The member of a field, if its value differs from `standard`.
template <class Field, class Noun>
void add_field(const Field& field, const Noun& noun, const Noun& standard, Pieces& members) {
  if (noun.*field.member != standard.*field.member)
    members.push_back(named(field.case_key, plain_piece(noun.*field.member)));
}

// The members of all plain fields whose value differs from `standard`.
template <HasFields Noun>
void add_fields(const Noun& noun, Pieces& members, const Noun& standard = {}) {
  for_each_plain_field<Noun>([&](const auto& field) { add_field(field, noun, standard, members); });
}

// An object of those members.
template <HasFields Noun>
JsonPiece plain_object_piece(const Noun& noun) {
  Pieces members;
  add_fields(noun, members);
  return json_object(std::move(members));
}

// The properties of plain fields in a schema: titles, descriptions, limits and defaults come from
// model/scene_fields.h, names from the enumerations.

// The definition to which a value refers; null: its type is written in place.
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

// A description with its limits filled in.
std::string with_limits(std::string_view description, Limits limits);

// "minimum" and "maximum"; for a width or size, "exclusiveMinimum".
void add_limits(Limits limits, bool is_size, Pieces& members);

template <class Value>
void add_type(Limits limits, Pieces& members) {
  if constexpr (kDefinition<Value> != nullptr)
    members.push_back(named("$ref", json_string(std::string("#/$defs/") + kDefinition<Value>)));
  else if constexpr (HasNames<Value>)
    members.push_back(named("enum", schema_names<Value>()));
  else
    members.push_back(
        named("type", json_string(std::is_same_v<Value, bool> ? "boolean" : "integer")));
  if constexpr (!HasNames<Value> && !std::is_same_v<Value, bool>)
    add_limits(limits, std::is_same_v<Value, Fixed>, members);
}

// Whether every plain field that is read from the list has a description.
template <HasFields Noun>
constexpr bool are_described() {
  bool all = true;
  for_each_plain_field<Noun>([&](const auto& field) { all = all && field.description != nullptr; });
  return all;
}

// One property for each plain field with a description in the list, whoever reads it.
template <HasFields Noun>
Pieces field_schemas() {
  static_assert(are_described<Noun>(), "a key of case files has no description in scene_fields.h");
  static const Noun standard;
  Pieces properties;
  for_each_field<Noun>([&](const auto& field) {
    using Value = std::remove_cvref_t<decltype(std::declval<Noun&>().*field.member)>;
    if constexpr (kIsPlain<Value>) {
      if (field.description == nullptr) return;
      Pieces members{
          named("title", json_string(field.label)),
          named("description", json_string(with_limits(field.description, field.limits)))};
      add_type<Value>(field.limits, members);
      if constexpr (!std::is_same_v<Value, std::optional<float>>)
        if (!field.is_required)
          members.push_back(named("default", plain_piece(standard.*field.member)));
      properties.push_back(named(field.case_key, json_object(std::move(members))));
    }
  });
  return properties;
}

}  // namespace edgecase
