// SPDX-License-Identifier: MIT
#include "casefile/blending_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "casefile/blend_presets.h"
#include "casefile/numbers.h"
#include "casefile/text.h"

namespace edgecase {
namespace {

constexpr const char* kBlending = "a blending";
constexpr const char* kTerm = "a term of a blending";

const Keys kTermKeys{{}, {"equation", "source", "destination"}, {}};
const Keys kOneTermKeys{{}, {"equation", "source", "destination", "constant"}, {}};
const Keys kTwoTermKeys{{"color", "alpha"}, {"constant"}, {}};

const Names kEquationNames{{"add", "subtract", "reverse_subtract", "min", "max"}, {}};
const Names kFactorNames{{"zero", "one", "src_color", "one_minus_src_color", "dst_color",
                          "one_minus_dst_color", "src_alpha", "one_minus_src_alpha", "dst_alpha",
                          "one_minus_dst_alpha", "constant_color", "one_minus_constant_color",
                          "constant_alpha", "one_minus_constant_alpha", "src_alpha_saturate"},
                         {}};

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
    read_enum(*place, "a factor", kFactorNames, findings, factor);
  } else {
    findings.add(term, fmt::format("a term of a blending lacks {}", quote(name)),
                 fmt::format("add \"{}\": \"one\", or another factor", name));
  }
}

BlendTerm read_members(const Place& place, const ObjectReader& object, Findings& findings) {
  BlendTerm term;
  if (!object.valid()) return term;
  if (const auto equation = object.find("equation"))
    if (!read_enum(*equation, "an equation", kEquationNames, findings, term.equation)) return term;
  read_factor(place, object, "source", term.equation, findings, term.source);
  read_factor(place, object, "destination", term.equation, findings, term.destination);
  return term;
}

BlendTerm read_term(const Place& place, Findings& findings) {
  return read_members(place, ObjectReader(place, kTerm, kTermKeys, findings), findings);
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

}  // namespace edgecase
