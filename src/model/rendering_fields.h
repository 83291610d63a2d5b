// SPDX-License-Identifier: MIT
//
// The further values of a fragment: for each its key in answers, its member, and the flag that
// requests it. Answers in binary and JSON, and their checks, walk over this list in its order.
#pragma once

#include <optional>
#include <tuple>

#include "model/rendering.h"
#include "model/scene_fields.h"

namespace edgecase {

template <class Value>
struct DetailField {
  const char* key;
  Value FragmentDetail::*member;
  bool Details::*asked;         // the flag of Scene::details that requests it
  bool is_of_textures = false;  // only fragments of textured draws have it

  constexpr DetailField of_textures() const { return {key, member, asked, true}; }
  // Whether a fragment may report it.
  constexpr bool is_asked(Details details, bool is_textured) const {
    return details.*asked && (is_textured || !is_of_textures);
  }
};

template <class Value>
constexpr DetailField<Value> detail_field(const char* key, Value FragmentDetail::*member,
                                          bool Details::*asked) {
  return {key, member, asked};
}

template <>
inline constexpr auto kFields<FragmentDetail> = std::tuple{
    detail_field("coordinates", &FragmentDetail::coordinates, &Details::coordinates),
    detail_field("derivatives", &FragmentDetail::derivatives, &Details::derivatives),
    detail_field("texture_coordinates", &FragmentDetail::texture_coordinates, &Details::texture)
        .of_textures(),
    detail_field("level_of_detail", &FragmentDetail::level_of_detail, &Details::texture)
        .of_textures()};

// Whether fragments of a draw may report any of them.
inline bool is_any_asked(Details details, bool is_textured) {
  bool any = false;
  for_each_field<FragmentDetail>(
      [&](const auto& field) { any = any || field.is_asked(details, is_textured); });
  return any;
}

// Whether the fragment reports it; for derivatives, any of them.
template <class Numbers>
bool is_reported(const std::optional<Numbers>& numbers) {
  return numbers.has_value();
}
inline bool is_reported(const DerivativeValues& derivatives) {
  return derivatives.has_any();
}

}  // namespace edgecase
