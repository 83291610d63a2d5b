// SPDX-License-Identifier: MIT
#include "casefile/blending.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "casefile/plain_fields.h"
#include "casefile/text.h"

namespace edgecase {
namespace {

constexpr const char* kBlending = "a blending";
constexpr const char* kTerm = "a term of a blending";

const Keys kTermKeys{{}, {"equation", "source", "destination"}, {}};
const Keys kOneTermKeys{{}, {"equation", "source", "destination", "constant"}, {}};
const Keys kTwoTermKeys{{"color", "alpha"}, {"constant"}, {}};

Blending read_preset(const Place& place, Findings& findings) {
  Names names;
  for (const BlendPreset& preset : kBlendPresets) names.allowed.push_back(preset.name);
  const auto name = read_choice(place, "a blending", names, findings);
  Blending blending;
  for (const BlendPreset& preset : kBlendPresets)
    if (name == preset.name) blending = {preset.color, preset.alpha, {}};
  return blending;
}

// A factor that is left out is no default, but a mistake, or one that plays no part.
void read_factor(const Place& term, const ObjectReader& object, const char* name,
                 BlendEquation equation, Findings& findings, BlendFactor& factor) {
  const auto place = object.find(name);
  if (!takes_factors(equation)) {
    if (place)
      findings.add_key(
          *place,
          fmt::format("{} takes no factors, and {} is one", quote(name_of(equation)), quote(name)),
          "remove it");
  } else if (place) {
    read_plain(*place, "a factor", {}, findings, factor);
  } else {
    findings.add(term, fmt::format("a term of a blending lacks {}", quote(name)),
                 fmt::format("add \"{}\": \"one\", or another factor", name));
  }
}

BlendTerm read_members(const Place& place, const ObjectReader& object, Findings& findings) {
  BlendTerm term;
  if (!object.valid()) return term;
  if (const auto equation = object.find("equation"))
    if (!read_plain(*equation, "an equation", {}, findings, term.equation)) return term;
  read_factor(place, object, "source", term.equation, findings, term.source);
  read_factor(place, object, "destination", term.equation, findings, term.destination);
  return term;
}

BlendTerm read_term(const Place& place, Findings& findings) {
  return read_members(place, ObjectReader(place, kTerm, kTermKeys, findings), findings);
}

Pieces term_pieces(const BlendTerm& term) {
  Pieces members;
  if (term.equation != BlendEquation::add)
    members.push_back(named("equation", plain_piece(term.equation)));
  if (!takes_factors(term.equation)) return members;
  members.push_back(named("source", plain_piece(term.source)));
  members.push_back(named("destination", plain_piece(term.destination)));
  return members;
}

}  // namespace

Blending read_blending(const Place& place, Findings& findings) {
  if (place.node->kind != JsonKind::object) {
    if (place.node->kind == JsonKind::string) return read_preset(place, findings);
    findings.add(place, fmt::format("a blending cannot be {}", describe(*place.node)),
                 "write a name like \"over\", or {\"source\": ..., \"destination\": ...}");
    return {};
  }
  const bool two = place.node->find("color") != nullptr || place.node->find("alpha") != nullptr;
  const ObjectReader object(place, kBlending, two ? kTwoTermKeys : kOneTermKeys, findings);
  Blending blending;
  if (two) {
    if (const auto color = object.find("color")) blending.color = read_term(*color, findings);
    if (const auto alpha = object.find("alpha")) blending.alpha = read_term(*alpha, findings);
  } else {
    blending.color = blending.alpha = read_members(place, object, findings);
  }
  if (const auto constant = object.find("constant"))
    blending.constant =
        read_color(*constant, "a constant colour", {0, 1}, findings).value_or(blending.constant);
  return blending;
}

JsonPiece blend_piece(const Blending& blending) {
  const Blending standard;
  const bool constant = blending.constant != standard.constant;
  for (const BlendPreset& preset : kBlendPresets)
    if (!constant && blending.color == preset.color && blending.alpha == preset.alpha)
      return json_string(preset.name);
  Pieces members;
  if (blending.color == blending.alpha)
    members = term_pieces(blending.color);
  else
    members = {named("color", json_object(term_pieces(blending.color))),
               named("alpha", json_object(term_pieces(blending.alpha)))};
  if (constant) members.push_back(named("constant", color_piece(blending.constant)));
  return json_object(std::move(members));
}

}  // namespace edgecase
