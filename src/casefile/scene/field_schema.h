// SPDX-License-Identifier: MIT
//
// The properties of plain fields in a schema: titles, descriptions, limits and defaults come from
// model/scene_fields.h, names from the enumerations.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "casefile/json/schema.h"
#include "casefile/scene/plain_fields.h"

namespace edgecase {

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
