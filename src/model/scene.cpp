// SPDX-License-Identifier: MIT
#include "model/scene.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "exact/numeral.h"
#include "model/clipped_line.h"
#include "model/fragment_operations.h"
#include "model/scene_fields.h"
#include "model/texture.h"

namespace edgecase {

bool has_fragment_operations(const Scene& scene) {
  const Target& target = scene.target;
  return target.stencil != StencilFormat::none || target.clear_depth != 1 ||
         std::any_of(scene.draws.begin(), scene.draws.end(),
                     [](const Draw& draw) { return draw.operations != FragmentOperations(); });
}

Color interpolated_attribute(const Draw& draw, const Vertex& vertex) {
  if (!draw.texture) return vertex.color;
  return {vertex.texture_coordinates[0], vertex.texture_coordinates[1], 0, 1};
}

bool is_in_clip_volume(const ClipPosition& clip) {
  return clip.w > 0 && std::fabs(clip.x) <= clip.w && std::fabs(clip.y) <= clip.w &&
         std::fabs(clip.z) <= clip.w;
}

bool is_between_near_and_far(const ClipPosition& clip) {
  return clip.w > 0 && std::fabs(clip.z) <= clip.w;
}

double unit_of(const ClipPosition& clip) {
  const float largest =
      std::max({std::fabs(clip.x), std::fabs(clip.y), std::fabs(clip.z), std::fabs(clip.w)});
  int exponent = 0;  // largest = m 2^exponent, 1/2 <= m < 1
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, exponent - 31);
}

namespace {

// The result has at most 31 bits.
std::int64_t in_units(float value, double unit) {
  return static_cast<std::int64_t>(static_cast<double>(value) / unit);
}

}  // namespace

HomogeneousPoint window_position(const ClipPosition& clip, const Viewport& viewport) {
  const double unit = unit_of(clip);
  // x/w runs from -1 to 1 across the viewport, whose centre is at x + width/2.
  const std::int64_t w = in_units(clip.w, unit);
  return {in_units(clip.x, unit) * viewport.width + (2 * viewport.x + viewport.width) * w,
          in_units(clip.y, unit) * viewport.height + (2 * viewport.y + viewport.height) * w, 2 * w};
}

PrimitiveKind kind_of(Primitive primitive) {
  switch (primitive) {
    case Primitive::points:
      return PrimitiveKind::point;
    case Primitive::lines:
    case Primitive::line_strip:
    case Primitive::line_loop:
      return PrimitiveKind::line;
    case Primitive::triangles:
    case Primitive::triangle_strip:
    case Primitive::triangle_fan:
      return PrimitiveKind::triangle;
  }
  return PrimitiveKind::triangle;
}

bool is_vertex_count(Primitive primitive, std::size_t count) {
  const auto size = static_cast<std::size_t>(vertices_of(kind_of(primitive)));
  const bool separate = primitive == Primitive::points || primitive == Primitive::lines ||
                        primitive == Primitive::triangles;
  return count >= size && (!separate || count % size == 0);
}

namespace {

// The vertices of a draw's primitive, by their indices in the draw, and which of them provoke.
struct Assembled {
  std::array<std::size_t, 3> vertices{};
  int provoking_first = 0;
  int provoking_last = 0;
};

std::size_t primitive_count(Primitive primitive, std::size_t vertices) {
  const auto size = static_cast<std::size_t>(vertices_of(kind_of(primitive)));
  if (vertices < size) return 0;
  switch (primitive) {
    case Primitive::points:
    case Primitive::lines:
    case Primitive::triangles:
      return vertices / size;
    case Primitive::line_loop:
      return vertices;
    case Primitive::line_strip:
      return vertices - 1;
    case Primitive::triangle_strip:
    case Primitive::triangle_fan:
      return vertices - 2;
  }
  return 0;
}

// Primitive i of a draw (GL 4.6 core, 10.1); the last segment of a loop returns to vertex 0.
Assembled assemble(Primitive primitive, std::size_t i, std::size_t vertices) {
  switch (primitive) {
    case Primitive::points:
      return {{i, 0, 0}, 0, 0};
    case Primitive::lines:
      return {{2 * i, 2 * i + 1, 0}, 0, 1};
    case Primitive::line_strip:
    case Primitive::line_loop:
      return {{i, (i + 1) % vertices, 0}, 0, 1};
    case Primitive::triangles:
      return {{3 * i, 3 * i + 1, 3 * i + 2}, 0, 2};
    // Every second triangle of a strip is reversed, so that all have the same winding.
    case Primitive::triangle_strip:
      if (i % 2 == 1) return {{i + 1, i, i + 2}, 1, 2};
      return {{i, i + 1, i + 2}, 0, 2};
    case Primitive::triangle_fan:
      return {{0, i + 1, i + 2}, 1, 2};
  }
  return {};
}

bool is_passed(const ScenePrimitive& primitive, const ClipPosition& clip) {
  const bool at_sides = primitive.clips_sides || primitive.kind == PrimitiveKind::triangle;
  return at_sides ? is_in_clip_volume(clip) : is_between_near_and_far(clip);
}

void place_vertex(ScenePrimitive& primitive, std::size_t at) {
  const Vertex& vertex = *primitive.vertices[at];
  if (!vertex.clip) {
    primitive.positions[at] = homogeneous(vertex.position);
    primitive.z[at] = vertex.z.raw();
    return;
  }
  primitive.positions[at] = window_position(*vertex.clip, primitive.viewport);
  primitive.units[at] = unit_of(*vertex.clip);
  primitive.z[at] = 2 * in_units(vertex.clip->z, primitive.units[at]);
  primitive.is_clipped = primitive.is_clipped || !is_passed(primitive, *vertex.clip);
}

// Cuts a line with a vertex outside the planes that clip it to the part inside.
void cut(ScenePrimitive& line) {
  const RationalClip from = rational_clip(*line.vertices[0], line.viewport);
  const RationalClip to = rational_clip(*line.vertices[1], line.viewport);
  const auto part = visible_part(from, to, line.clips_sides);
  if (!part) return;
  const auto start = window_place(between(from, to, part->from), line.viewport);
  const auto end = window_place(between(from, to, part->to), line.viewport);
  if (!start || !end) return;
  line.positions[0] = *start;
  line.positions[1] = *end;
  line.is_clipped = false;
  line.is_cut = true;
}

// Gives a primitive that has its vertices their positions, or those of what clipping leaves.
void place(ScenePrimitive& primitive) {
  primitive.is_clipped = primitive.is_cut = false;
  for (int v = 0; v < vertices_of(primitive.kind); ++v)
    place_vertex(primitive, static_cast<std::size_t>(v));
  if (primitive.kind == PrimitiveKind::line && primitive.is_clipped) cut(primitive);
}

}  // namespace

bool has_clip_positions(const ScenePrimitive& primitive) {
  const auto count = static_cast<std::size_t>(vertices_of(primitive.kind));
  return std::any_of(primitive.vertices.begin(), primitive.vertices.begin() + count,
                     [](const Vertex* vertex) { return vertex->clip.has_value(); });
}

bool has_perspective(const ScenePrimitive& primitive) {
  const auto count = static_cast<std::size_t>(vertices_of(primitive.kind));
  return std::any_of(primitive.vertices.begin(), primitive.vertices.begin() + count,
                     [&](const Vertex* vertex) { return vertex->w != primitive.vertices[0]->w; });
}

ScenePrimitive with_sides(ScenePrimitive primitive, bool clips_sides) {
  primitive.clips_sides = clips_sides;
  place(primitive);
  return primitive;
}

std::vector<ScenePrimitive> primitives_of(const Scene& scene) {
  std::vector<ScenePrimitive> result;
  for (std::size_t d = 0; d < scene.draws.size(); ++d) {
    const Draw& draw = scene.draws[d];
    const std::size_t count = primitive_count(draw.primitive, draw.vertices.size());
    for (std::size_t i = 0; i < count; ++i) {
      const Assembled assembled = assemble(draw.primitive, i, draw.vertices.size());
      ScenePrimitive primitive;
      primitive.index = static_cast<int>(result.size());
      primitive.draw = static_cast<int>(d);
      primitive.kind = kind_of(draw.primitive);
      primitive.state = &draw;
      primitive.depth_range = scene.depth_range;
      primitive.viewport = scene.viewport;
      primitive.clips_sides = scene.clips_sides;
      for (std::size_t v = 0; v < static_cast<std::size_t>(vertices_of(primitive.kind)); ++v)
        primitive.vertices[v] = &draw.vertices[assembled.vertices[v]];
      place(primitive);
      primitive.provoking_first = assembled.provoking_first;
      primitive.provoking_last = assembled.provoking_last;
      result.push_back(primitive);
    }
  }
  return result;
}

bool holds(CompareFunction function, bool less, bool equal) {
  switch (function) {
    case CompareFunction::never:
      return false;
    case CompareFunction::less:
      return less;
    case CompareFunction::equal:
      return equal;
    case CompareFunction::lequal:
      return less || equal;
    case CompareFunction::greater:
      return !less && !equal;
    case CompareFunction::notequal:
      return !equal;
    case CompareFunction::gequal:
      return !less;
    case CompareFunction::always:
      return true;
  }
  return true;
}

int level_size(int size, int level) {
  return level < 31 ? std::max(1, size >> level) : 1;
}

int level_count(int width, int height) {
  int count = 1;
  for (int size = std::max(width, height); size > 1; size /= 2) ++count;
  return count;
}

namespace {

constexpr std::size_t kMostPrimitives = 3;  // listed one by one
constexpr std::size_t kMostVertices = 6;    // listed of a strip, loop or fan

// The shortest decimal that reads back as the same float32 number.
std::string decimal_of(float value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string text_of(Point point) {
  return "(" + to_fraction(point.x) + ", " + to_fraction(point.y) + ")";
}

// The vertices from `from` up to `to`, exclusive.
std::string list_vertices(const Draw& draw, std::size_t from, std::size_t to,
                          std::string_view separator) {
  std::string text;
  for (std::size_t i = from; i < to; ++i) {
    if (i != from) text += separator;
    text += text_of(draw.vertices[i].position);
    if (draw.vertices[i].w != 1) text += " w " + decimal_of(draw.vertices[i].w);
  }
  return text;
}

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// Separate primitives: "line A to B and line C to D", or the first of many.
std::string separate_text(const Draw& draw) {
  const PrimitiveKind kind = kind_of(draw.primitive);
  const auto each = static_cast<std::size_t>(vertices_of(kind));
  const std::size_t count = draw.vertices.size() / each;
  const std::size_t shown = count <= kMostPrimitives ? count : 1;
  const std::string_view separator = kind == PrimitiveKind::line ? " to " : ", ";
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i != 0) text += " and ";
    text += std::string(name_of(kind)) + " ";
    text += list_vertices(draw, i * each, (i + 1) * each, separator);
  }
  if (shown == count) return text;
  return std::to_string(count) + " " + name_of(draw.primitive) + ", the first " + text;
}

std::string connected_text(const Draw& draw) {
  const std::size_t count = draw.vertices.size();
  const std::size_t shown = std::min(count, kMostVertices);
  std::string text = spaced(name_of(draw.primitive)) + " " + list_vertices(draw, 0, shown, ", ");
  if (shown != count) text += " and " + std::to_string(count - shown) + " more";
  return text;
}

// A value in words.

template <class Number>
requires std::is_arithmetic_v<Number> std::string words_of(Number value) {
  if constexpr (std::is_same_v<Number, bool>) return value ? "on" : "off";
  if constexpr (std::is_same_v<Number, float>) return decimal_of(value);
  return std::to_string(value);
}
std::string words_of(Fixed value) {
  return to_fraction(value);
}
template <HasNames Enum>
std::string words_of(Enum value) {
  return spaced(name_of(value));
}
std::string words_of(const std::optional<Viewport>& box) {
  return words_of(box->width) + "x" + words_of(box->height) + " at (" + words_of(box->x) + ", " +
         words_of(box->y) + ")";
}
std::string words_of(const std::optional<TextureUse>& use) {
  const Sampler& sampler = use->sampler;
  std::string text = std::to_string(use->texture) + " " + name_of(sampler.wrap[0]) + " " +
                     name_of(sampler.wrap[1]) + ", magnified " + name_of(sampler.magnify) +
                     ", minified " + name_of(sampler.minify) + ", levels " +
                     name_of(sampler.mipmap);
  if (use->lookup.kind != LookupKind::implicit)
    text += std::string(", ") + name_of(use->lookup.kind);
  return text;
}
std::string words_of(const DepthTest& test) {
  const bool tests = test.function != CompareFunction::always;
  return (tests ? std::string("depth ") + name_of(test.function) : "") +
         (tests && !test.write ? ", " : "") + (test.write ? "" : "depth not written");
}
std::string words_of(const std::array<bool, 4>& mask) {
  std::string text;
  for (std::size_t i = 0; i < mask.size(); ++i) text += mask[i] ? "rgba"[i] : '-';
  return text;
}

template <class Value>
concept HasWords = requires(const Value& value) {
  words_of(value);
};

template <class Value>
std::string row_text(const char* key, const char* words, const Value& value) {
  std::string text = words != nullptr ? words : spaced(key) + (HasWords<Value> ? " {}" : "");
  const std::size_t place = text.find("{}");
  if constexpr (HasWords<Value>)
    if (place != text.npos) text.replace(place, 2, words_of(value));
  return ", " + text;
}

// What differs from the default, sizes first.
std::string state_text(const Draw& draw) {
  Draw standard;
  standard.primitive = draw.primitive;
  std::string text;
  for (const bool sizes : {true, false})
    for_each_row<Draw>([&](const auto& field, const auto& part) {
      const auto& value = part(draw).*field.member;
      using Value = std::remove_cvref_t<decltype(value)>;
      if constexpr (!std::is_same_v<Value, std::vector<Vertex>> &&
                    !std::is_same_v<Value, Multisampling>)
        if (std::is_same_v<Value, Fixed> == sizes && value != part(standard).*field.member)
          text += row_text(field.key, field.words, value);
    });
  return text;
}

std::string draw_text(const Draw& draw) {
  const auto each = static_cast<std::size_t>(vertices_of(kind_of(draw.primitive)));
  // One more point completes the next primitive of a strip, but not a separate one.
  const bool connected = each > 1 && is_vertex_count(draw.primitive, each + 1);
  return (connected ? connected_text(draw) : separate_text(draw)) + state_text(draw);
}

bool same_texture(const std::shared_ptr<const Texture>& a,
                  const std::shared_ptr<const Texture>& b) {
  return a == b || *a == *b;
}

}  // namespace

std::string scene_text(const Scene& scene) {
  std::string text;
  for (const Draw& draw : scene.draws) {
    if (!text.empty()) text += "; ";
    text += draw_text(draw);
  }
  if (!text.empty()) text += ", ";
  text += std::to_string(scene.target.width) + "x" + std::to_string(scene.target.height);
  if (scene.target.samples != 1) text += ", " + std::to_string(scene.target.samples) + " samples";
  if (!scene.supersampling.empty())
    text += ", " + std::to_string(scene.supersampling.size()) +
            (scene.supersampling.size() == 1 ? " pass" : " passes");
  if (scene.target.depth != DepthFormat::none)
    text += std::string(", ") + name_of(scene.target.depth);
  if (scene.target.stencil != StencilFormat::none)
    text += std::string(", ") + name_of(scene.target.stencil);
  if (scene.target.surface != Surface::fbo)
    text += std::string(", ") + name_of(scene.target.surface);
  return text;
}

bool same_scene(const Scene& a, const Scene& b) {
  return a.target == b.target && a.viewport == b.viewport && a.depth_range == b.depth_range &&
         a.details == b.details && a.supersampling == b.supersampling && a.draws == b.draws &&
         std::ranges::equal(a.textures, b.textures, same_texture);
}

}  // namespace edgecase
