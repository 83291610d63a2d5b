// SPDX-License-Identifier: MIT
#include "casefile/fragment_operations_reader.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "casefile/blending_reader.h"
#include "casefile/numbers.h"
#include "casefile/text.h"

namespace edgecase {
namespace {

constexpr const char* kStencil = "stencil";
constexpr const char* kClearDepth = "clear_depth";
constexpr const char* kClearStencil = "clear_stencil";
constexpr const char* kDepthRange = "depth_range";
constexpr const char* kDepth = "depth";
constexpr const char* kBlend = "blend";
constexpr const char* kColorMask = "color_mask";
constexpr const char* kFrontFace = "front_face";
constexpr const char* kCull = "cull";
constexpr const char* kPolygonOffset = "polygon_offset";

const Keys kDepthKeys{{}, {"test", "write"}, {}};
const Keys kFaceKeys{
    {}, {"test", "reference", "read_mask", "write_mask", "fail", "depth_fail", "pass"}, {}};
const Keys kTwoFaceKeys{{}, {"front", "back"}, {}};
const Keys kOffsetKeys{{}, {"factor", "units", "clamp"}, {}};

const std::vector<std::string> kFunctions{"never",   "less",     "equal",  "lequal",
                                          "greater", "notequal", "gequal", "always"};
const Names kStencilOperations{
    {"keep", "zero", "replace", "incr", "incr_wrap", "decr", "decr_wrap", "invert"}, {}};

constexpr Float32Range kDepths{0, 1};
// Of factor and units: 2^24 units are the whole depth of 24 bits. And an offset of more than 1
// leaves it wherever it starts.
constexpr Float32Range kOffsets{-16777216, 16777216};
constexpr Float32Range kOffsetClamps{-1, 1};

void read_float_into(const ObjectReader& object, const char* name, Float32Range range,
                     Findings& findings, float& value) {
  if (const auto place = object.find(name))
    value = read_float32(*place, name, range, Float32Kind::exact, findings).value_or(value);
}

void read_byte_into(const ObjectReader& object, const char* name, Findings& findings,
                    std::uint8_t& value) {
  if (const auto place = object.find(name))
    value = static_cast<std::uint8_t>(
        read_integer(*place, name, {0, 255}, findings).value_or(int{value}));
}

void read_stencil_format(const ObjectReader& object, TargetFields& fields, Findings& findings) {
  const auto place = object.find(kStencil);
  if (!place) return;
  fields.stencil_known = read_enum(*place, "a stencil format", {{"none", "stencil8"}, {}}, findings,
                                   fields.target.stencil);
  if (fields.target.stencil != StencilFormat::none && fields.target.depth == DepthFormat::depth16)
    findings.add(*place, "OpenGL has no format of \"depth16\" and \"stencil8\" together",
                 "write \"depth\": \"depth24\" or \"depth32f\", or remove one of the two");
}

// Nothing of it would count, and what is ignored would pass for tested.
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
  const auto ends = read_float32s<2>(place, kDepthRange, kDepths, Float32Kind::exact, findings);
  if (ends) range = {(*ends)[0], (*ends)[1]};
}

// A function's name, "off", or {"test", "write"}.
DepthTest read_depth_test(const Place& place, Findings& findings) {
  DepthTest test;
  if (place.node->kind != JsonKind::object) {
    Names names{kFunctions, {}};
    names.allowed.push_back("off");
    const auto name = read_choice(place, "a depth test", names, findings);
    if (name == "off") test.write = false;
    if (name && name != "off") parse_name(*name, test.function);
    return test;
  }
  const ObjectReader object(place, "a depth test", kDepthKeys, findings);
  if (const auto function = object.find("test"))
    read_enum(*function, "a depth test", {kFunctions, {}}, findings, test.function);
  const auto write = object.find("write");
  if (write && expect_kind(*write, JsonKind::boolean, "write", findings))
    test.write = write->node->truth;
  return test;
}

StencilFace read_members(const ObjectReader& object, Findings& findings) {
  StencilFace face;
  if (const auto function = object.find("test"))
    read_enum(*function, "a stencil test", {kFunctions, {}}, findings, face.function);
  read_byte_into(object, "reference", findings, face.reference);
  read_byte_into(object, "read_mask", findings, face.read_mask);
  read_byte_into(object, "write_mask", findings, face.write_mask);
  const std::array<std::pair<const char*, StencilOperation*>, 3> operations{
      {{"fail", &face.fail}, {"depth_fail", &face.depth_fail}, {"pass", &face.pass}}};
  for (const auto& [name, operation] : operations)
    if (const auto place = object.find(name))
      read_enum(*place, name, kStencilOperations, findings, *operation);
  return face;
}

StencilFace read_face(const Place& place, Findings& findings) {
  return read_members(ObjectReader(place, "a face of a stencil test", kFaceKeys, findings),
                      findings);
}

// The keys of a face, for both, or {"front", "back"}.
StencilTest read_stencil_test(const Place& place, Findings& findings) {
  StencilTest test;
  const JsonNode& node = *place.node;
  const bool two = node.kind == JsonKind::object &&
                   (node.find("front") != nullptr || node.find("back") != nullptr);
  const ObjectReader object(place, "a stencil test", two ? kTwoFaceKeys : kFaceKeys, findings);
  if (!two) {
    test.front = test.back = read_members(object, findings);
    return test;
  }
  if (const auto front = object.find("front")) test.front = read_face(*front, findings);
  if (const auto back = object.find("back")) test.back = read_face(*back, findings);
  return test;
}

std::array<bool, 4> read_color_mask(const Place& place, Findings& findings) {
  std::array<bool, 4> mask{};
  const auto text = read_text(place, "a colour mask", {0, 200}, findings);
  if (!text) return FragmentOperations().color_mask;
  std::string_view rest = *text;
  constexpr std::string_view kLetters = "rgba";
  for (std::size_t i = 0; i < mask.size(); ++i) {
    mask[i] = rest.starts_with(kLetters[i]);
    if (mask[i]) rest.remove_prefix(1);
  }
  if (!rest.empty())
    findings.add(place, fmt::format("{} is no colour mask", quote(*text)),
                 "write the letters of \"rgba\" that are written, in this order");
  return mask;
}

PolygonOffset read_polygon_offset(const Place& place, Findings& findings) {
  PolygonOffset offset;
  const ObjectReader object(place, "a polygon offset", kOffsetKeys, findings);
  read_float_into(object, "factor", kOffsets, findings, offset.factor);
  read_float_into(object, "units", kOffsets, findings, offset.units);
  read_float_into(object, "clamp", kOffsetClamps, findings, offset.clamp);
  return offset;
}

void read_facing(const ObjectReader& state, Draw& draw, Findings& findings) {
  if (const auto face = state.find(kFrontFace))
    read_enum(*face, "the front face", {{"ccw", "cw"}, {}}, findings, draw.front_face);
  if (const auto cull = state.find(kCull))
    read_enum(*cull, kCull, {{"none", "front", "back", "front_and_back"}, {}}, findings, draw.cull);
}

// A test on a buffer that the target does not have passes, whatever it asks.
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
  return {kStencil, kClearDepth, kClearStencil, kDepthRange};
}

void read_target_operations(const ObjectReader& object, TargetFields& fields, Findings& findings) {
  Target& target = fields.target;
  read_stencil_format(object, fields, findings);
  read_float_into(object, kClearDepth, kDepths, findings, target.clear_depth);
  read_byte_into(object, kClearStencil, findings, target.clear_stencil);
  if (const auto range = object.find(kDepthRange))
    read_depth_range(*range, fields.depth_range, findings);
  refuse_clear_values_of_nothing(object, fields, findings);
  if (!fields.supersample_place) return;
  if (target.stencil != StencilFormat::none) refuse_beside_passes(object, kStencil, findings);
  if (target.clear_depth != 1) refuse_beside_passes(object, kClearDepth, findings);
}

std::vector<std::string> fragment_operation_keys() {
  return {kDepth, kStencil, kBlend, kColorMask, kFrontFace, kCull, kPolygonOffset};
}

void read_fragment_operations(const ObjectReader& state, const TargetFields& target, Draw& draw,
                              Findings& findings) {
  FragmentOperations& operations = draw.operations;
  if (const auto depth = state.find(kDepth)) operations.depth = read_depth_test(*depth, findings);
  if (const auto stencil = state.find(kStencil))
    operations.stencil = read_stencil_test(*stencil, findings);
  if (const auto blend = state.find(kBlend)) operations.blending = read_blending(*blend, findings);
  if (const auto mask = state.find(kColorMask))
    operations.color_mask = read_color_mask(*mask, findings);
  read_facing(state, draw, findings);
  if (const auto offset = state.find(kPolygonOffset))
    draw.polygon_offset = read_polygon_offset(*offset, findings);
  refuse_without_buffer(state, target, draw, findings);
  if (!target.supersample_place) return;
  const FragmentOperations standard;
  if (operations.depth != standard.depth) refuse_beside_passes(state, kDepth, findings);
  if (operations.stencil) refuse_beside_passes(state, kStencil, findings);
  if (operations.blending) refuse_beside_passes(state, kBlend, findings);
  if (operations.color_mask != standard.color_mask)
    refuse_beside_passes(state, kColorMask, findings);
}

}  // namespace edgecase
