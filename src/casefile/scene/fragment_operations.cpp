// SPDX-License-Identifier: MIT
#include "casefile/scene/fragment_operations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "casefile/json/text.h"
#include "casefile/scene/forms.h"

namespace edgecase {

namespace {

constexpr const char* kBlending = "a blending";
constexpr const char* kTerm = "a term of a blending";

const Keys kTermKeys{{}, {"equation", "source", "destination"}, {}};
const Keys kOneTermKeys{{}, {"equation", "source", "destination", "constant"}, {}};
const Keys kTwoTermKeys{{"color", "alpha"}, {"constant"}, {}};

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const BlendPreset& preset : kBlendPresets) names.emplace_back(preset.name);
  return names;
}

Blending read_preset(const Place& place, Findings& findings) {
  const auto name = read_choice(place, kBlending, {preset_names(), {}}, findings);
  Blending blending;
  for (const BlendPreset& preset : kBlendPresets)
    if (name == preset.name) blending = {preset.color, preset.alpha, {}};
  return blending;
}

// A missing factor never means a default: it is a mistake, unless factors are ignored.
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

// Faults add a finding and leave the default of Blending.
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

}  // namespace

void Form<std::optional<Blending>>::read(const Place& place, const char*, Limits,
                                         Findings& findings, std::optional<Blending>& value) {
  value = read_blending(place, findings);
}

// The shortest form.
JsonPiece Form<std::optional<Blending>>::piece(const std::optional<Blending>& value) {
  const Blending& blending = *value;
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

void Form<std::optional<Blending>>::describe(Limits, Pieces& members) {
  members.push_back(reference_to("blend"));
}

// Tests and masks.

namespace {

constexpr const char* kStencil = "stencil";
constexpr const char* kClearDepth = "clear_depth";
constexpr const char* kClearStencil = "clear_stencil";
constexpr const char* kDepthRange = "depth_range";
constexpr const char* kDepth = "depth";
constexpr const char* kPolygonOffset = "polygon_offset";
constexpr std::string_view kLetters = "rgba";

const Keys kTwoFaceKeys{{}, {"front", "back"}, {}};

void read_stencil_format(const ObjectReader& object, TargetFields& fields, Findings& findings) {
  const auto place = object.find(kStencil);
  if (!place) return;
  fields.stencil_known =
      read_plain(*place, "a stencil format", {}, findings, fields.target.stencil);
  if (fields.target.stencil != StencilFormat::none && fields.target.depth == DepthFormat::depth16)
    findings.add(*place, "OpenGL has no format of \"depth16\" and \"stencil8\" together",
                 "write \"depth\": \"depth24\" or \"depth32f\", or remove one of the two");
}

// These would have no effect, and ignored keys would seem to be tested.
void refuse_clear_values_of_nothing(const ObjectReader& object, const TargetFields& fields,
                                    Findings& findings) {
  const auto refuse = [&](const char* key, const char* buffer, const char* remedy) {
    if (const auto place = object.find(key))
      findings.add_key(
          *place, fmt::format("{} is of a {} buffer, and the target has none", quote(key), buffer),
          remedy);
  };
  if (fields.depth_known && fields.target.depth == DepthFormat::none)
    refuse(kClearDepth, "depth", "write \"depth\": \"depth24\" into the target, or remove the key");
  if (fields.stencil_known && fields.target.stencil == StencilFormat::none)
    refuse(kClearStencil, "stencil",
           "write \"stencil\": \"stencil8\" into the target, or remove the key");
}

void refuse_beside_passes(const ObjectReader& object, const char* key, Findings& findings) {
  if (const auto place = object.find(key))
    findings.add_key(*place,
                     fmt::format("{} does not come together with \"supersample\" yet", quote(key)),
                     "remove one of the two");
}

void read_depth_range(const Place& place, DepthRange& range, Findings& findings) {
  const auto ends = read_float32s<2>(place, kDepthRange, {0, 1}, Float32Kind::exact, findings);
  if (ends) range = {(*ends)[0], (*ends)[1]};
}

// A test on a buffer that the target lacks would always pass.
void refuse_without_buffer(const ObjectReader& state, const TargetFields& target, const Draw& draw,
                           Findings& findings) {
  const auto refuse = [&](const char* key, const char* buffer, const char* remedy) {
    if (const auto place = state.find(key))
      findings.add_key(
          *place, fmt::format("{} needs a {} buffer, and the target has none", quote(key), buffer),
          remedy);
  };
  if (target.depth_known && target.target.depth == DepthFormat::none) {
    constexpr const char* kRemedy =
        "write \"depth\": \"depth24\" into the target, or remove the key";
    if (draw.operations.depth != DepthTest{CompareFunction::always, false})
      refuse(kDepth, kDepth, kRemedy);
    refuse(kPolygonOffset, kDepth, kRemedy);
  }
  if (target.stencil_known && target.target.stencil == StencilFormat::none)
    refuse(kStencil, kStencil,
           "write \"stencil\": \"stencil8\" into the target, or remove the key");
}

}  // namespace

std::vector<std::string> target_operation_keys() {
  return {kStencil, kDepthRange};
}

void read_target_operations(const ObjectReader& object, TargetFields& fields, Findings& findings) {
  Target& target = fields.target;
  read_stencil_format(object, fields, findings);
  if (const auto range = object.find(kDepthRange))
    read_depth_range(*range, fields.depth_range, findings);
  refuse_clear_values_of_nothing(object, fields, findings);
  if (!fields.supersample_place) return;
  if (target.stencil != StencilFormat::none) refuse_beside_passes(object, kStencil, findings);
  if (target.clear_depth != 1) refuse_beside_passes(object, kClearDepth, findings);
}

void check_fragment_operations(const ObjectReader& state, const TargetFields& target,
                               const Draw& draw, Findings& findings) {
  refuse_without_buffer(state, target, draw, findings);
  if (!target.supersample_place) return;
  const FragmentOperations standard;
  for_each_form<FragmentOperations>([&](const auto& field, const auto&) {
    if (draw.operations.*field.member != standard.*field.member)
      refuse_beside_passes(state, field.case_key, findings);
  });
}

// A function's name, "off", or {"test", "write"}.

void Form<DepthTest>::read(const Place& place, const char* title, Limits, Findings& findings,
                           DepthTest& test) {
  if (place.node->kind == JsonKind::object) {
    test = read_object<DepthTest>(place, title, findings);
    return;
  }
  Names names{names_of<CompareFunction>(), {}};
  names.allowed.emplace_back(kDepthOff);
  const auto name = read_choice(place, title, names, findings);
  if (name == kDepthOff) test.write = false;
  if (name && name != kDepthOff) parse_name(*name, test.function);
}

JsonPiece Form<DepthTest>::piece(const DepthTest& test) {
  if (test.write) return json_string(name_of(test.function));
  if (test.function == CompareFunction::always) return json_string(kDepthOff);
  return json_object(
      {named("test", json_string(name_of(test.function))), named("write", json_scalar("false"))});
}

void Form<DepthTest>::describe(Limits, Pieces& members) {
  members.push_back(reference_to("depth_test"));
}

// The keys of one face for both, or {"front", "back"}.

void Form<std::optional<StencilTest>>::read(const Place& place, const char* title, Limits,
                                            Findings& findings, std::optional<StencilTest>& value) {
  constexpr const char* kFace = "a face of a stencil test";
  StencilTest& test = value.emplace();
  const JsonNode& node = *place.node;
  const bool two = node.kind == JsonKind::object &&
                   (node.find("front") != nullptr || node.find("back") != nullptr);
  const ObjectReader object(place, title, two ? kTwoFaceKeys : object_keys<StencilFace>(),
                            findings);
  if (!two) {
    read_fields(object, findings, test.front);
    test.back = test.front;
    return;
  }
  if (const auto front = object.find("front"))
    test.front = read_object<StencilFace>(*front, kFace, findings);
  if (const auto back = object.find("back"))
    test.back = read_object<StencilFace>(*back, kFace, findings);
}

JsonPiece Form<std::optional<StencilTest>>::piece(const std::optional<StencilTest>& value) {
  if (value->front == value->back) return object_piece(value->front);
  Pieces members;
  const StencilFace standard;
  if (value->front != standard) members.push_back(named("front", object_piece(value->front)));
  if (value->back != standard) members.push_back(named("back", object_piece(value->back)));
  return json_object(std::move(members));
}

void Form<std::optional<StencilTest>>::describe(Limits, Pieces& members) {
  members.push_back(reference_to("stencil_test"));
}

// Some of the letters "rgba".

void Form<ColorMask>::read(const Place& place, const char* title, Limits, Findings& findings,
                           ColorMask& mask) {
  const auto text = read_text(place, title, {0, 200}, findings);
  if (!text) return;
  std::string_view rest = *text;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    mask[i] = rest.starts_with(kLetters[i]);
    if (mask[i]) rest.remove_prefix(1);
  }
  if (!rest.empty())
    findings.add(place, fmt::format("{} is no colour mask", quote(*text)),
                 "write the letters of \"rgba\" that are written, in this order");
}

JsonPiece Form<ColorMask>::piece(const ColorMask& mask) {
  std::string text;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) text += kLetters[i];
  return json_string(text);
}

void Form<ColorMask>::describe(Limits, Pieces& members) {
  members.push_back(named("type", json_string("string")));
  members.push_back(named("pattern", json_string("^r?g?b?a?$")));
}

}  // namespace edgecase
