// SPDX-License-Identifier: MIT
#include "wire/operation_values.h"

#include <cstdint>
#include <nlohmann/json.hpp>

namespace edgecase::wire {

using nlohmann::json;

namespace {

constexpr FloatRange kDepths{0, 1, "a float32 value of 0 to 1"};

void write_face(Output out, const StencilFace& face) {
  fmt::format_to(out,
                 R"({{"test":"{}","reference":{},"read_mask":{},"write_mask":{},"fail":"{}",)"
                 R"("depth_fail":"{}","pass":"{}"}})",
                 name_of(face.function), face.reference, face.read_mask, face.write_mask,
                 name_of(face.fail), name_of(face.depth_fail), name_of(face.pass));
}

void write_term(Output out, const BlendTerm& term) {
  fmt::format_to(out, R"({{"equation":"{}","source":"{}","destination":"{}"}})",
                 name_of(term.equation), name_of(term.source), name_of(term.destination));
}

void write_blending(Output out, const Blending& blending) {
  fmt::format_to(out, R"(,"blend":{{"color":)");
  write_term(out, blending.color);
  fmt::format_to(out, R"(,"alpha":)");
  write_term(out, blending.alpha);
  fmt::format_to(out, R"(,"constant":)");
  write_color(out, blending.constant);
  *out++ = '}';
}

void write_offset(Output out, const PolygonOffset& offset) {
  fmt::format_to(out, R"(,"polygon_offset":{{"factor":)");
  write_number(out, static_cast<double>(offset.factor));
  fmt::format_to(out, R"(,"units":)");
  write_number(out, static_cast<double>(offset.units));
  fmt::format_to(out, R"(,"clamp":)");
  write_number(out, static_cast<double>(offset.clamp));
  *out++ = '}';
}

std::uint8_t read_byte(const json& object, const Path& path, const char* key) {
  return static_cast<std::uint8_t>(read_integer(member(object, path, key), {path, key}, 0, 255));
}

StencilFace read_face(const json& value, const Path& path) {
  require_object(value, path,
                 {"test", "reference", "read_mask", "write_mask", "fail", "depth_fail", "pass"});
  StencilFace face;
  face.function = read_name<CompareFunction>(value, path, "test");
  face.reference = read_byte(value, path, "reference");
  face.read_mask = read_byte(value, path, "read_mask");
  face.write_mask = read_byte(value, path, "write_mask");
  face.fail = read_name<StencilOperation>(value, path, "fail");
  face.depth_fail = read_name<StencilOperation>(value, path, "depth_fail");
  face.pass = read_name<StencilOperation>(value, path, "pass");
  return face;
}

StencilTest read_stencil(const json& value, const Path& path) {
  require_object(value, path, {"front", "back"});
  return {read_face(member(value, path, "front"), {path, "front"}),
          read_face(member(value, path, "back"), {path, "back"})};
}

DepthTest read_depth(const json& value, const Path& path) {
  require_object(value, path, {"test", "write"});
  return {read_name<CompareFunction>(value, path, "test"),
          read_bool(member(value, path, "write"), {path, "write"})};
}

BlendTerm read_term(const json& value, const Path& path) {
  require_object(value, path, {"equation", "source", "destination"});
  return {read_name<BlendEquation>(value, path, "equation"),
          read_name<BlendFactor>(value, path, "source"),
          read_name<BlendFactor>(value, path, "destination")};
}

Blending read_blending(const json& value, const Path& path) {
  require_object(value, path, {"color", "alpha", "constant"});
  return {read_term(member(value, path, "color"), {path, "color"}),
          read_term(member(value, path, "alpha"), {path, "alpha"}),
          read_clear_color(member(value, path, "constant"), {path, "constant"})};
}

PolygonOffset read_offset(const json& value, const Path& path) {
  require_object(value, path, {"factor", "units", "clamp"});
  const auto read = [&](const char* key) {
    return read_any_float32(member(value, path, key), {path, key});
  };
  return {read("factor"), read("units"), read("clamp")};
}

std::array<bool, 4> read_color_mask(const json& value, const Path& path) {
  require_array(value, path, 4);
  std::array<bool, 4> mask{};
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = read_bool(value[i], {path, i});
  return mask;
}

}  // namespace

void write_buffers(Output out, const Target& target) {
  const Target standard;
  if (target.stencil != standard.stencil)
    fmt::format_to(out, R"(,"stencil":"{}")", name_of(target.stencil));
  if (target.clear_depth != standard.clear_depth) {
    fmt::format_to(out, R"(,"clear_depth":)");
    write_number(out, static_cast<double>(target.clear_depth));
  }
  if (target.clear_stencil != standard.clear_stencil)
    fmt::format_to(out, R"(,"clear_stencil":{})", target.clear_stencil);
}

void read_buffers(const json& value, const Path& path, Target& target) {
  if (value.contains("stencil")) target.stencil = read_name<StencilFormat>(value, path, "stencil");
  if (const json* depth = optional_member(value, "clear_depth"))
    target.clear_depth = read_float32(*depth, {path, "clear_depth"}, kDepths);
  if (value.contains("clear_stencil"))
    target.clear_stencil = read_byte(value, path, "clear_stencil");
}

void write_depth_range(Output out, const DepthRange& range) {
  *out++ = '[';
  write_number(out, static_cast<double>(range.near));
  *out++ = ',';
  write_number(out, static_cast<double>(range.far));
  *out++ = ']';
}

DepthRange read_depth_range(const json& value, const Path& path) {
  require_array(value, path, 2);
  return {read_float32(value[0], {path, std::size_t{0}}, kDepths),
          read_float32(value[1], {path, std::size_t{1}}, kDepths)};
}

void write_operations(Output out, const Draw& draw) {
  const Draw standard;
  const FragmentOperations& operations = draw.operations;
  if (draw.front_face != standard.front_face)
    fmt::format_to(out, R"(,"front_face":"{}")", name_of(draw.front_face));
  if (draw.cull != standard.cull) fmt::format_to(out, R"(,"cull":"{}")", name_of(draw.cull));
  if (draw.polygon_offset) write_offset(out, *draw.polygon_offset);
  if (operations.stencil) {
    fmt::format_to(out, R"(,"stencil":{{"front":)");
    write_face(out, operations.stencil->front);
    fmt::format_to(out, R"(,"back":)");
    write_face(out, operations.stencil->back);
    *out++ = '}';
  }
  if (operations.depth != standard.operations.depth)
    fmt::format_to(out, R"(,"depth":{{"test":"{}","write":{}}})",
                   name_of(operations.depth.function), operations.depth.write);
  if (operations.blending) write_blending(out, *operations.blending);
  if (operations.color_mask != standard.operations.color_mask)
    fmt::format_to(out, R"(,"color_mask":[{}])", fmt::join(operations.color_mask, ","));
}

void read_operations(const json& value, const Path& path, Draw& draw) {
  if (value.contains("front_face"))
    draw.front_face = read_name<FrontFace>(value, path, "front_face");
  if (value.contains("cull")) draw.cull = read_name<CullMode>(value, path, "cull");
  if (const json* offset = optional_member(value, "polygon_offset"))
    draw.polygon_offset = read_offset(*offset, {path, "polygon_offset"});
  FragmentOperations& operations = draw.operations;
  if (const json* stencil = optional_member(value, "stencil"))
    operations.stencil = read_stencil(*stencil, {path, "stencil"});
  if (const json* depth = optional_member(value, "depth"))
    operations.depth = read_depth(*depth, {path, "depth"});
  if (const json* blend = optional_member(value, "blend"))
    operations.blending = read_blending(*blend, {path, "blend"});
  if (const json* mask = optional_member(value, "color_mask"))
    operations.color_mask = read_color_mask(*mask, {path, "color_mask"});
}

}  // namespace edgecase::wire
