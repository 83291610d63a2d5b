// SPDX-License-Identifier: MIT
//
// A scene is written twice on its way, by who asks and by who checks the digest, and hundreds of
// thousands of times by whoever measures a driver: it is formatted straight into the text.
#include "wire/request_line.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "wire/reading.h"

namespace edgecase {

using nlohmann::json;
using wire::Path;
using wire::Refusal;

namespace {

constexpr int kMaxSize = 4096;
constexpr int kMaxViewport = 32768;
// Of a line's width and a point's size, in pixels.
constexpr int kMaxThickness = 64;
// The value of "answer" in a request for coverage alone.
constexpr std::string_view kCoverageAnswer = "coverage";

using Output = std::back_insert_iterator<fmt::memory_buffer>;

// A finite number as the shortest decimal that reads back as the same double: 1.0, not 1, so that
// coordinates and colours look like what they are.
void write_number(Output out, double value) {
  std::array<char, 32> text;
  const char* end = fmt::format_to_n(text.data(), text.size(), "{}", value).out;
  const std::string_view digits(text.data(), static_cast<std::size_t>(end - text.data()));
  const bool whole = digits.find_first_of(".e") == digits.npos;
  fmt::format_to(out, "{}{}", digits, whole ? ".0" : "");
}

void write(Output out, const Color& color) {
  for (std::size_t i = 0; i < color.size(); ++i) {
    *out++ = i == 0 ? '[' : ',';
    write_number(out, static_cast<double>(color[i]));
  }
  *out++ = ']';
}

void write(Output out, const Viewport& box) {
  fmt::format_to(out, "[{},{},{},{}]", box.x, box.y, box.width, box.height);
}

void write(Output out, const Vertex& vertex);
void write(Output out, const Draw& draw);

template <class Item>
void write_all(Output out, const std::vector<Item>& items) {
  *out++ = '[';
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) *out++ = ',';
    write(out, items[i]);
  }
  *out++ = ']';
}

void write(Output out, const Vertex& vertex) {
  fmt::format_to(out, R"({{"position":[)");
  write_number(out, vertex.position.x.to_double());
  *out++ = ',';
  write_number(out, vertex.position.y.to_double());
  *out++ = ',';
  write_number(out, vertex.z.to_double());
  fmt::format_to(out, R"(],"color":)");
  write(out, vertex.color);
  *out++ = '}';
}

void write(Output out, const Draw& draw) {
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
  fmt::format_to(out, R"(,"vertices":)");
  write_all(out, draw.vertices);
  *out++ = '}';
}

void write(Output out, const Target& target) {
  fmt::format_to(out, R"({{"width":{},"height":{},"samples":{},"color":"{}","surface":"{}")",
                 target.width, target.height, target.samples, name_of(target.color),
                 name_of(target.surface));
  fmt::format_to(out, R"(,"clear":)");
  write(out, target.clear);
  *out++ = '}';
}

Color read_color(const json& value, const Path& path) {
  wire::require_array(value, path, 4);
  Color color{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Path at(path, i);
    const double number = wire::read_finite(value[i], at);
    color[i] = static_cast<float>(number);
    if (!(number >= 0 && number <= 1) || static_cast<double>(color[i]) != number)
      throw Refusal(fmt::format("{} is {}, but it must be a float32 value of 0 to 1", at.text(),
                                value[i].dump()));
  }
  return color;
}

Fixed read_fixed(const json& value, const Path& path) {
  const double number = wire::read_finite(value, path);
  const double raw = number * static_cast<double>(Fixed::kOne);
  if (!(number >= -Fixed::kMaxCoordinate && number <= Fixed::kMaxCoordinate) ||
      raw != static_cast<double>(static_cast<std::int64_t>(raw)))
    throw Refusal(fmt::format("{} is {}, but it must be a multiple of 2^-16 of -8192 to 8192",
                              path.text(), value.dump()));
  return Fixed::from_raw(static_cast<std::int64_t>(raw));
}

// A line's width or a point's size.
Fixed read_thickness(const json& draw, const Path& path, const char* key) {
  const Path at(path, key);
  const json& value = wire::member(draw, path, key);
  const Fixed thickness = read_fixed(value, at);
  if (thickness <= Fixed() || thickness > Fixed::from_integer(kMaxThickness))
    throw Refusal(fmt::format("{} is {}, but it must be more than 0 and at most {}", at.text(),
                              value.dump(), kMaxThickness));
  return thickness;
}

int read_int(const json& value, const Path& path, int low, int high) {
  return static_cast<int>(wire::read_integer(value, path, low, high));
}

template <class Enum>
Enum read_name(const json& object, const Path& path, const char* key) {
  const Path at(path, key);
  const std::string& name = wire::read_string(wire::member(object, path, key), at);
  Enum value{};
  if (!parse_name(name, value))
    throw Refusal(fmt::format("{} is the unknown name \"{}\"", at.text(), wire::excerpt(name, 40)));
  return value;
}

Target read_target(const json& value, const Path& path) {
  wire::require_object(value, path, {"width", "height", "samples", "color", "surface", "clear"});
  Target target;
  target.width = read_int(wire::member(value, path, "width"), {path, "width"}, 1, kMaxSize);
  target.height = read_int(wire::member(value, path, "height"), {path, "height"}, 1, kMaxSize);
  target.samples = read_int(wire::member(value, path, "samples"), {path, "samples"}, 1, 32);
  target.color = read_name<ColorFormat>(value, path, "color");
  target.surface = read_name<Surface>(value, path, "surface");
  target.clear = read_color(wire::member(value, path, "clear"), {path, "clear"});
  return target;
}

// x, y, width and height; both sizes at least `smallest`.
Viewport read_box(const json& value, const Path& path, int smallest) {
  wire::require_array(value, path, 4);
  return {read_int(value[0], {path, std::size_t{0}}, -kMaxViewport, kMaxViewport),
          read_int(value[1], {path, std::size_t{1}}, -kMaxViewport, kMaxViewport),
          read_int(value[2], {path, std::size_t{2}}, smallest, kMaxViewport),
          read_int(value[3], {path, std::size_t{3}}, smallest, kMaxViewport)};
}

Vertex read_vertex(const json& value, const Path& path) {
  wire::require_object(value, path, {"position", "color"});
  const json& position = wire::member(value, path, "position");
  const Path at(path, "position");
  wire::require_array(position, at, 3);
  Vertex vertex;
  vertex.position.x = read_fixed(position[0], {at, std::size_t{0}});
  vertex.position.y = read_fixed(position[1], {at, std::size_t{1}});
  vertex.z = read_fixed(position[2], {at, std::size_t{2}});
  vertex.color = read_color(wire::member(value, path, "color"), {path, "color"});
  return vertex;
}

Draw read_draw(const json& value, const Path& path) {
  wire::require_object(value, path,
                       {"primitive", "interpolation", "provoking_vertex", "line_width",
                        "point_size", "scissor", "vertices"});
  Draw draw;
  draw.primitive = read_name<Primitive>(value, path, "primitive");
  draw.interpolation = read_name<Interpolation>(value, path, "interpolation");
  draw.provoking_vertex = read_name<ProvokingVertex>(value, path, "provoking_vertex");
  draw.line_width = read_thickness(value, path, "line_width");
  draw.point_size = read_thickness(value, path, "point_size");
  if (const json* scissor = wire::optional_member(value, "scissor"))
    draw.scissor = read_box(*scissor, {path, "scissor"}, 0);
  const json& vertices = wire::member(value, path, "vertices");
  const Path at(path, "vertices");
  wire::require_array(vertices, at, vertices.size());
  if (!is_vertex_count(draw.primitive, vertices.size()))
    throw Refusal(fmt::format("{} has {} vertices, which make no whole {}", at.text(),
                              vertices.size(), name_of(draw.primitive)));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    draw.vertices.push_back(read_vertex(vertices[i], {at, i}));
  return draw;
}

Scene read_scene(const json& value, const Path& path) {
  wire::require_object(value, path, {"target", "viewport", "draws"});
  Scene scene;
  scene.target = read_target(wire::member(value, path, "target"), {path, "target"});
  scene.viewport = read_box(wire::member(value, path, "viewport"), {path, "viewport"}, 1);
  const json& draws = wire::member(value, path, "draws");
  const Path at(path, "draws");
  wire::require_array(draws, at, draws.size());
  for (std::size_t i = 0; i < draws.size(); ++i)
    scene.draws.push_back(read_draw(draws[i], {at, i}));
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
  write(out, scene.target);
  fmt::format_to(out, R"(,"viewport":)");
  write(out, scene.viewport);
  fmt::format_to(out, R"(,"draws":)");
  write_all(out, scene.draws);
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
