// SPDX-License-Identifier: MIT
//
// A scene is written twice on its way, by who asks and by who checks the digest, and hundreds of
// thousands of times by whoever measures a driver: it is formatted straight into the text.
#include "wire/request_line.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "wire/operation_values.h"
#include "wire/reading.h"
#include "wire/sample_values.h"
#include "wire/scene_values.h"
#include "wire/supersampling_values.h"
#include "wire/texture_values.h"

namespace edgecase {

using nlohmann::json;
using wire::Output;
using wire::Path;
using wire::read_int;
using wire::read_name;
using wire::Refusal;
using wire::write_number;

namespace {

constexpr int kMaxSize = 4096;
constexpr int kMaxViewport = 32768;
// Of a line's width and a point's size, in pixels.
constexpr int kMaxThickness = 64;
// The value of "answer" in a request for coverage alone.
constexpr std::string_view kCoverageAnswer = "coverage";
// What "details" lists, in this order.
constexpr std::string_view kCoordinatesWord = "coordinates";
constexpr std::string_view kDerivativesWord = "derivatives";
constexpr std::string_view kTextureWord = "texture";

void write(Output out, const Viewport& box) {
  fmt::format_to(out, "[{},{},{},{}]", box.x, box.y, box.width, box.height);
}

template <class Item, class Write>
void write_all(Output out, const std::vector<Item>& items, Write write_item) {
  *out++ = '[';
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) *out++ = ',';
    write_item(items[i]);
  }
  *out++ = ']';
}

void write(Output out, const Draw& draw, int samples) {
  fmt::format_to(out, R"({{"primitive":"{}","interpolation":"{}","provoking_vertex":"{}")",
                 name_of(draw.primitive), name_of(draw.interpolation),
                 name_of(draw.provoking_vertex));
  fmt::format_to(out, R"(,"line_width":)");
  write_number(out, draw.line_width.to_double());
  fmt::format_to(out, R"(,"point_size":)");
  write_number(out, draw.point_size.to_double());
  if (draw.scissor) {
    fmt::format_to(out, R"(,"scissor":)");
    write(out, *draw.scissor);
  }
  if (samples > 1) {
    fmt::format_to(out, R"(,"multisampling":)");
    wire::write_multisampling(out, draw.multisampling, samples);
  }
  if (draw.texture) {
    fmt::format_to(out, R"(,"texture":)");
    wire::write_texture_use(out, *draw.texture);
  }
  wire::write_operations(out, draw);
  fmt::format_to(out, R"(,"vertices":)");
  write_all(out, draw.vertices, [&](const Vertex& vertex) {
    wire::write_vertex(out, vertex, draw.texture.has_value());
  });
  *out++ = '}';
}

// The whole member, or nothing where no detail is asked for.
void write_details(Output out, Details details) {
  if (!details.any()) return;
  std::vector<std::string> names;
  if (details.coordinates) names.push_back(fmt::format("\"{}\"", kCoordinatesWord));
  if (details.derivatives) names.push_back(fmt::format("\"{}\"", kDerivativesWord));
  if (details.texture) names.push_back(fmt::format("\"{}\"", kTextureWord));
  fmt::format_to(out, R"(,"details":[{}])", fmt::join(names, ","));
}

// The whole member, or nothing where there are none.
void write_textures(Output out, const Scene& scene) {
  if (scene.textures.empty()) return;
  fmt::format_to(out, R"(,"textures":)");
  write_all(out, scene.textures, [&](const std::shared_ptr<const Texture>& texture) {
    wire::write_texture(out, *texture);
  });
}

void write_target(Output out, const Scene& scene) {
  const Target& target = scene.target;
  fmt::format_to(out, R"({{"width":{},"height":{},"samples":{})", target.width, target.height,
                 target.samples);
  if (!target.sample_positions.empty()) {
    fmt::format_to(out, R"(,"sample_positions":)");
    wire::write_positions(out, target.sample_positions);
  }
  fmt::format_to(out, R"(,"color":"{}")", name_of(target.color));
  if (target.depth != DepthFormat::none)
    fmt::format_to(out, R"(,"depth":"{}")", name_of(target.depth));
  wire::write_buffers(out, target);
  fmt::format_to(out, R"(,"surface":"{}","clear":)", name_of(target.surface));
  wire::write_color(out, target.clear);
  if (!scene.supersampling.empty()) {
    fmt::format_to(out, R"(,"supersampling":)");
    wire::write_supersampling(out, scene.supersampling);
  }
  *out++ = '}';
}

// A line's width or a point's size.
Fixed read_thickness(const json& draw, const Path& path, const char* key) {
  const Path at(path, key);
  const json& value = wire::member(draw, path, key);
  const Fixed thickness = wire::read_fixed(value, at);
  if (thickness <= Fixed() || thickness > Fixed::from_integer(kMaxThickness))
    throw Refusal(fmt::format("{} is {}, but it must be more than 0 and at most {}", at.text(),
                              value.dump(), kMaxThickness));
  return thickness;
}

void read_target(const json& value, const Path& path, Scene& scene) {
  wire::require_object(
      value, path,
      {"width", "height", "samples", "sample_positions", "color", "depth", "stencil", "clear_depth",
       "clear_stencil", "surface", "clear", "supersampling"});
  Target& target = scene.target;
  target.width = read_int(wire::member(value, path, "width"), {path, "width"}, 1, kMaxSize);
  target.height = read_int(wire::member(value, path, "height"), {path, "height"}, 1, kMaxSize);
  target.samples =
      read_int(wire::member(value, path, "samples"), {path, "samples"}, 1, kMaxSamples);
  if (const json* positions = wire::optional_member(value, "sample_positions"))
    target.sample_positions =
        wire::read_positions(*positions, {path, "sample_positions"}, target.samples);
  target.color = read_name<ColorFormat>(value, path, "color");
  if (value.contains("depth")) target.depth = read_name<DepthFormat>(value, path, "depth");
  wire::read_buffers(value, path, target);
  target.surface = read_name<Surface>(value, path, "surface");
  target.clear = wire::read_clear_color(wire::member(value, path, "clear"), {path, "clear"});
  if (const json* passes = wire::optional_member(value, "supersampling"))
    scene.supersampling =
        wire::read_supersampling(*passes, {path, "supersampling"}, target.samples);
}

// x, y, width and height; both sizes at least `smallest`.
Viewport read_box(const json& value, const Path& path, int smallest) {
  wire::require_array(value, path, 4);
  return {read_int(value[0], {path, std::size_t{0}}, -kMaxViewport, kMaxViewport),
          read_int(value[1], {path, std::size_t{1}}, -kMaxViewport, kMaxViewport),
          read_int(value[2], {path, std::size_t{2}}, smallest, kMaxViewport),
          read_int(value[3], {path, std::size_t{3}}, smallest, kMaxViewport)};
}

// There where the target has several samples, and nowhere else.
void read_multisampling(const json& value, const Path& path, int samples, Draw& draw) {
  if (samples > 1)
    draw.multisampling = wire::read_multisampling(wire::member(value, path, "multisampling"),
                                                  {path, "multisampling"}, samples);
  else if (value.contains("multisampling"))
    throw Refusal(path.text() + " has \"multisampling\", but the target has one sample");
}

// A draw of a scene whose target, viewport and textures have been read.
Draw read_draw(const json& value, const Path& path, const Scene& scene) {
  wire::require_object(value, path,
                       {"primitive", "interpolation", "provoking_vertex", "line_width",
                        "point_size", "scissor", "multisampling", "texture", "front_face", "cull",
                        "polygon_offset", "stencil", "depth", "blend", "color_mask", "vertices"});
  Draw draw;
  draw.primitive = read_name<Primitive>(value, path, "primitive");
  draw.interpolation = read_name<Interpolation>(value, path, "interpolation");
  draw.provoking_vertex = read_name<ProvokingVertex>(value, path, "provoking_vertex");
  draw.line_width = read_thickness(value, path, "line_width");
  draw.point_size = read_thickness(value, path, "point_size");
  if (const json* scissor = wire::optional_member(value, "scissor"))
    draw.scissor = read_box(*scissor, {path, "scissor"}, 0);
  read_multisampling(value, path, scene.target.samples, draw);
  if (const json* texture = wire::optional_member(value, "texture"))
    draw.texture = wire::read_texture_use(*texture, {path, "texture"}, scene);
  wire::read_operations(value, path, draw);
  const json& vertices = wire::member(value, path, "vertices");
  const Path at(path, "vertices");
  wire::require_array(vertices, at, vertices.size());
  if (!is_vertex_count(draw.primitive, vertices.size()))
    throw Refusal(fmt::format("{} has {} vertices, which make no whole {}", at.text(),
                              vertices.size(), name_of(draw.primitive)));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    draw.vertices.push_back(
        wire::read_vertex(vertices[i], {at, i}, scene.viewport, draw.texture.has_value()));
  return draw;
}

// Names, none of them twice; one at least, since a scene without is told by leaving out the key.
Details read_details(const json& value, const Path& path) {
  wire::require_array(value, path, value.size());
  if (value.empty()) throw Refusal(path.text() + " must have an element");
  Details details;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Path at(path, i);
    const std::string& name = wire::read_string(value[i], at);
    bool* const detail = name == kCoordinatesWord   ? &details.coordinates
                         : name == kDerivativesWord ? &details.derivatives
                         : name == kTextureWord     ? &details.texture
                                                    : nullptr;
    if (detail == nullptr) wire::refuse_name(name, at);
    if (*detail) throw Refusal(fmt::format("{} names \"{}\" again", at.text(), name));
    *detail = true;
  }
  return details;
}

void read_textures(const json& value, const Path& path, Scene& scene) {
  wire::require_array(value, path, value.size());
  if (value.empty()) throw Refusal(path.text() + " must have an element");
  for (std::size_t i = 0; i < value.size(); ++i)
    scene.textures.push_back(
        std::make_shared<const Texture>(wire::read_texture(value[i], {path, i})));
}

Scene read_scene(const json& value, const Path& path) {
  wire::require_object(value, path,
                       {"target", "viewport", "depth_range", "details", "textures", "draws"});
  Scene scene;
  const Path target(path, "target");
  read_target(wire::member(value, path, "target"), target, scene);
  scene.viewport = read_box(wire::member(value, path, "viewport"), {path, "viewport"}, 1);
  if (const json* range = wire::optional_member(value, "depth_range"))
    scene.depth_range = wire::read_depth_range(*range, {path, "depth_range"});
  if (const json* details = wire::optional_member(value, "details"))
    scene.details = read_details(*details, {path, "details"});
  if (const json* textures = wire::optional_member(value, "textures"))
    read_textures(*textures, {path, "textures"}, scene);
  const json& draws = wire::member(value, path, "draws");
  const Path at(path, "draws");
  wire::require_array(draws, at, draws.size());
  for (std::size_t i = 0; i < draws.size(); ++i)
    scene.draws.push_back(read_draw(draws[i], {at, i}, scene));
  wire::check_passes(scene, {target, "supersampling"});
  if (!scene.supersampling.empty() && has_fragment_operations(scene))
    throw Refusal(Path(target, "supersampling").text() +
                  " is there, but the scene has fragment operations");
  return scene;
}

Request read_request(const json& document) {
  const Path root;
  wire::require_object(document, root, {"edgecase", "id", "digest", "answer", "scene"});
  wire::read_integer(wire::member(document, root, "edgecase"), {root, "edgecase"}, kProtocolVersion,
                     kProtocolVersion);
  Request request;
  request.id = wire::read_string(wire::member(document, root, "id"), {root, "id"});
  request.digest = wire::read_string(wire::member(document, root, "digest"), {root, "digest"});
  if (const json* answer = wire::optional_member(document, "answer")) {
    const std::string& name = wire::read_string(*answer, {root, "answer"});
    if (name != kCoverageAnswer)
      throw Refusal(fmt::format("/answer is \"{}\", but it must be \"{}\"", wire::excerpt(name, 40),
                                kCoverageAnswer));
    request.coverage_only = true;
  }
  request.scene = read_scene(wire::member(document, root, "scene"), {root, "scene"});
  const std::string digest = digest_of(scene_json(request.scene));
  if (digest != request.digest)
    throw Refusal(fmt::format("/digest is \"{}\", but the scene's is \"{}\"",
                              wire::excerpt(request.digest, 40), digest));
  return request;
}

}  // namespace

std::string scene_json(const Scene& scene) {
  fmt::memory_buffer text;
  const Output out(text);
  fmt::format_to(out, R"({{"target":)");
  write_target(out, scene);
  fmt::format_to(out, R"(,"viewport":)");
  write(out, scene.viewport);
  if (scene.depth_range != DepthRange()) {
    fmt::format_to(out, R"(,"depth_range":)");
    wire::write_depth_range(out, scene.depth_range);
  }
  write_details(out, scene.details);
  write_textures(out, scene);
  fmt::format_to(out, R"(,"draws":)");
  write_all(out, scene.draws, [&](const Draw& draw) { write(out, draw, scene.target.samples); });
  text.push_back('}');
  return fmt::to_string(text);
}

std::string digest_of(std::string_view scene_json) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (char c : scene_json) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return fmt::format("{:016x}", hash);
}

std::string request_line(const std::string& id, std::string_view scene_json, bool coverage_only) {
  const std::string quoted = json(id).dump(-1, ' ', true, json::error_handler_t::replace);
  const std::string answer =
      coverage_only ? fmt::format(R"("answer":"{}",)", kCoverageAnswer) : std::string();
  return fmt::format(R"({{"edgecase":{},"id":{},"digest":"{}",{}"scene":{}}})", kProtocolVersion,
                     quoted, digest_of(scene_json), answer, scene_json);
}

std::variant<Request, WireError> parse_request(std::string_view line) {
  try {
    return read_request(wire::parse_text(line));
  } catch (const Refusal& refusal) {
    return WireError{refusal.what()};
  }
}

}  // namespace edgecase
