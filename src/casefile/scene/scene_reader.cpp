// SPDX-License-Identifier: MIT
#include "casefile/scene/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "casefile/mesh/mesh.h"
#include "casefile/mesh/transform.h"
#include "casefile/scene/forms.h"
#include "casefile/scene/fragment_operations.h"
#include "casefile/scene/samples.h"
#include "casefile/scene/textures.h"
#include "casefile/scene/viewport.h"

namespace edgecase {
namespace {

// Whole pixels from `left` to `right` and from `bottom` to `top`; the latter are excluded.
struct Box {
  std::int64_t left = 0;
  std::int64_t bottom = 0;
  std::int64_t right = 0;
  std::int64_t top = 0;

  std::int64_t width() const { return std::max<std::int64_t>(right - left, 0); }
  std::int64_t height() const { return std::max<std::int64_t>(top - bottom, 0); }
  std::int64_t area() const { return width() * height(); }
};

Box common(const Box& a, const Box& b) {
  return {std::max(a.left, b.left), std::max(a.bottom, b.bottom), std::min(a.right, b.right),
          std::min(a.top, b.top)};
}

Box drawable(const Draw& draw, const Target& target) {
  const Box whole{0, 0, target.width, target.height};
  if (!draw.scissor) return whole;
  const Viewport& s = *draw.scissor;
  return common(whole, {s.x, s.y, std::int64_t{s.x} + s.width, std::int64_t{s.y} + s.height});
}

// A box with all pixels that a primitive touches: that of its vertices, grown by `thickness` on
// each side, in whole pixels.
Box box_of(const ScenePrimitive& primitive, std::int64_t thickness) {
  const auto count = static_cast<std::size_t>(vertices_of(primitive.kind));
  Point low = primitive.vertices[0]->position;
  Point high = low;
  for (std::size_t i = 1; i < count; ++i) {
    const Point at = primitive.vertices[i]->position;
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  return {low.x.floor() - thickness, low.y.floor() - thickness, high.x.floor() + 1 + thickness,
          high.y.floor() + 1 + thickness};
}

// The pixels between a primitive's corners, inclusive, if each corner lies before the eye. Corners
// far beyond the window are moved closer, where still no target reaches.
std::optional<Box> box_of_corners(const ScenePrimitive& primitive) {
  constexpr std::int64_t kFar = std::int64_t{1} << 16;
  Box box{kFar, kFar, -kFar, -kFar};
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(primitive.kind)); ++i) {
    const HomogeneousPoint& at = primitive.positions[i];
    if (at.w <= 0) return std::nullopt;
    const auto column = [&](std::int64_t numerator) {
      const std::int64_t whole = numerator / at.w - (numerator % at.w < 0 ? 1 : 0);
      return std::clamp(whole, -kFar, kFar);
    };
    box = {std::min(box.left, column(at.x)), std::min(box.bottom, column(at.y)),
           std::max(box.right, column(at.x) + 1), std::max(box.top, column(at.y) + 1)};
  }
  return box;
}

// An upper bound of a length, in whole pixels.
std::int64_t whole_pixels(Fixed length) {
  return length.floor() + 1;
}

Fixed half(Fixed length) {
  return Fixed::from_raw(length.raw() / 2);
}

std::int64_t most_pixels(const ScenePrimitive& primitive, const Box& drawable) {
  if (primitive.is_clipped && primitive.kind == PrimitiveKind::triangle)
    return common(box_of_corners(primitive).value_or(drawable), drawable).area();
  if (primitive.is_clipped || primitive.is_cut) return drawable.area();
  const Draw& draw = *primitive.state;
  if (primitive.kind == PrimitiveKind::point)
    return common(box_of(primitive, whole_pixels(half(draw.point_size))), drawable).area();
  if (primitive.kind == PrimitiveKind::line) {
    // Per column (per row if steep) a line rises by at most one pixel, and its height is less than
    // 1.5 times its width.
    const Box box = common(box_of(primitive, whole_pixels(half(draw.line_width))), drawable);
    const std::int64_t across = 2 * whole_pixels(draw.line_width) + 2;
    return std::min(box.area(), std::max(box.width(), box.height()) * across);
  }
  // A triangle is at most half its box, and its border touches at most twice as many pixels as the
  // box's border.
  const Box box = box_of(primitive, 0);
  const std::int64_t inside = box.area() / 2 + 2 * (box.width() + box.height()) + 4;
  return std::min(inside, common(box, drawable).area());
}

}  // namespace

std::uint64_t most_drawn_samples(const Scene& scene) {
  std::uint64_t pixels = 0;
  for (const ScenePrimitive& primitive : primitives_of(scene))
    pixels += static_cast<std::uint64_t>(
        most_pixels(primitive, drawable(*primitive.state, scene.target)));
  const std::size_t passes = std::max<std::size_t>(scene.supersampling.size(), 1);
  return pixels * static_cast<std::uint64_t>(scene.target.samples) * passes;
}

void check_draw_work(const Scene& scene, const Place& draws, Findings& findings) {
  const std::uint64_t samples = most_drawn_samples(scene);
  if (samples > kMaxDrawnSamples)
    findings.add(draws, fmt::format("the primitives may cover {} samples", samples),
                 fmt::format("draw less, or to a smaller target: {} samples at most, each counted "
                             "as often as it is covered",
                             kMaxDrawnSamples));
}

namespace {

Keys target_keys() {
  Keys keys{required_keys<Target>(),
            {"samples", "sample_positions", "depth", "clear", "viewport", "y", "supersample"},
            {}};
  for (std::string& name : keys_of<Target>()) keys.optional.push_back(std::move(name));
  for (std::string& name : target_operation_keys()) keys.optional.push_back(std::move(name));
  return keys;
}

}  // namespace

TargetFields read_target(const Place& place, Findings& findings) {
  static const Keys kTargetKeys = target_keys();
  TargetFields fields;
  const ObjectReader object(place, "a target", kTargetKeys, findings);
  fields.depth_known = fields.stencil_known = object.valid();
  read_fields(object, findings, fields.target);
  if (const auto depth = object.find("depth"))
    fields.depth_known = read_plain(*depth, "a depth format", {}, findings, fields.target.depth);
  read_samples(object, fields, findings);
  read_supersample(object, fields, findings);
  read_target_operations(object, fields, findings);
  if (const auto clear = object.find("clear"))
    fields.clear = read_color(*clear, "a clear colour", {0, 1}, findings);
  if (const auto viewport = object.find("viewport"))
    fields.viewport = read_rectangle(*viewport, "a viewport", 1, findings);
  if (const auto y = object.find("y"))
    fields.y_down = read_choice(*y, "the direction of y", {{"up", "down"}, {}}, findings) == "down";
  return fields;
}

namespace {

const Keys kDrawKeys{{"primitive"}, {"vertices", "mesh", "state", "color", "transform"}, {}};
Keys state_keys() {
  Keys keys{{}, keys_of<Draw>(), {}};
  for (const char* name : {"texture", "sampler", "lookup"}) keys.optional.emplace_back(name);
  for (std::string& name : multisampling_keys()) keys.optional.push_back(std::move(name));
  return keys;
}

constexpr Float32Range kColorRange{-kMaxColor, kMaxColor};

TextureState read_state(const Place& place, const DrawContext& context, Draw& draw,
                        Findings& findings) {
  static const Keys kStateKeys = state_keys();
  const ObjectReader object(place, "a state", kStateKeys, findings);
  read_fields(object, findings, draw);
  draw.multisampling = read_multisampling(object, context.target.target.samples, findings);
  check_fragment_operations(object, context.target, draw, findings);
  TextureState texture = read_texture_state(object, context.textures, findings);
  draw.texture = texture.use;
  // Flat lookups would show one texel throughout, so that has to be requested.
  if (draw.texture && !object.find("interpolation")) draw.interpolation = Interpolation::smooth;
  return texture;
}

// Refuses `count` vertices, which do not make whole primitives.
void refuse_count(const Place& place, Primitive primitive, std::size_t count, Findings& findings) {
  const int each = vertices_of(kind_of(primitive));
  const bool connected = is_vertex_count(primitive, static_cast<std::size_t>(each) + 1);
  if (connected)
    findings.add(place,
                 fmt::format("a {} has {} vertices, and needs {}", name_of(primitive), count, each),
                 fmt::format("write {} vertices or more", each));
  else
    findings.add(place,
                 fmt::format("a draw has {} vertices, and each primitive takes {}", count, each),
                 fmt::format("write a multiple of {}", each));
}

void read_vertices(const Place& place, std::optional<Primitive> primitive,
                   const VertexDefaults& defaults, Findings& findings,
                   std::vector<VertexFields>& vertices) {
  if (!expect_kind(place, JsonKind::array, "a list of vertices", findings)) return;
  const std::size_t count = place.node->children.size();
  if (count == 0) {
    findings.add(place, "a draw has no vertices", "add the vertices of at least one primitive");
  } else if (primitive && !is_vertex_count(*primitive, count)) {
    refuse_count(place, *primitive, count, findings);
  }
  vertices.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    vertices.push_back(read_vertex(place.child(i), defaults, findings));
}

void read_mesh(const Place& place, std::optional<Primitive> primitive,
               const VertexDefaults& defaults, MeshShelf& meshes, Findings& findings,
               std::vector<VertexFields>& vertices) {
  if (primitive && *primitive != Primitive::triangles)
    findings.add(place, fmt::format("a mesh cannot be drawn as {}", name_of(*primitive)),
                 "write \"primitive\": \"triangles\"");
  if (const Mesh* mesh = meshes.find(place, findings))
    vertices = mesh_vertices(*mesh, place, defaults, findings);
}

// A part of a transform without any effect would seem to be tested.
void check_use(const Transform& transform, TransformUse use, Findings& findings) {
  if (transform.affine_place && !use.affine)
    findings.add(*transform.affine_place, "affine maps move window coordinates, and none are given",
                 "give vertices as [x, y] or \"at\", or remove it");
  if (transform.has_matrix && !use.matrix)
    findings.add(transform.place,
                 "model, view and projection are for object space, and no vertex lies in it",
                 "give vertices as \"object\" or a mesh, or remove them");
}

// Moves the vertices of a draw; returns which parts of the case's transform had an effect.
TransformUse transform_draw(const std::optional<Place>& own, const Transform* of_case,
                            Findings& findings, std::vector<VertexFields>& vertices) {
  const std::size_t before = findings.size();
  if (own) {
    const Transform transform = read_transform(*own, findings);
    if (findings.size() != before) return {};
    check_use(transform, transform_vertices(&transform, vertices, findings), findings);
    return {};
  }
  return transform_vertices(of_case, vertices, findings);
}

// `use`: of the case's transform, by draws without one of their own.
DrawFields read_draw(const Place& place, const DrawContext& context, TransformUse& use,
                     Findings& findings) {
  const std::size_t before = findings.size();
  DrawFields fields;
  const ObjectReader object(place, "a draw", kDrawKeys, findings);
  std::optional<Primitive> known;
  if (const auto primitive = object.find("primitive")) {
    if (read_plain(*primitive, "a primitive", {}, findings, fields.draw.primitive))
      known = fields.draw.primitive;
  }
  VertexDefaults defaults;
  if (const auto state = object.find("state")) {
    const TextureState texture = read_state(*state, context, fields.draw, findings);
    defaults.textured = texture.textured;
    defaults.dimensions = texture.dimensions;
  }
  if (const auto given = object.find("color")) {
    defaults.color = read_color(*given, "a draw's colour", kColorRange, findings);
    if (defaults.textured)
      findings.add_key(*given, "a textured draw has a colour, and its texture gives it",
                       "remove it");
  }
  const auto vertices = object.find("vertices");
  const auto mesh = object.find("mesh");
  if (vertices && mesh)
    findings.add(place, "a draw has both \"vertices\" and \"mesh\"", "give exactly one of the two");
  else if (vertices)
    read_vertices(*vertices, known, defaults, findings, fields.vertices);
  else if (mesh)
    read_mesh(*mesh, known, defaults, context.meshes, findings, fields.vertices);
  else if (object.valid())
    findings.add(place, "a draw lacks \"vertices\"", "add \"vertices\": [...], or a \"mesh\"");
  const auto transform = object.find("transform");
  // Refused vertices have placeholder numbers, whose positions must not be judged.
  if (findings.size() == before) {
    const TransformUse own =
        transform_draw(transform, context.transform, findings, fields.vertices);
    use.affine = use.affine || own.affine;
    use.matrix = use.matrix || own.matrix;
  } else if (transform) {
    read_transform(*transform, findings);
  }
  return fields;
}

}  // namespace

std::vector<DrawFields> read_draws(const Place& place, const DrawContext& context,
                                   Findings& findings) {
  const std::size_t before = findings.size();
  std::vector<DrawFields> draws;
  if (!expect_kind(place, JsonKind::array, "the list of draws", findings)) return draws;
  const std::size_t count = place.node->children.size();
  if (count == 0 || count > kMaxDraws) {
    findings.add(place, fmt::format("a case has {} draws", count),
                 fmt::format("write 1 to {} draws", kMaxDraws));
  }
  TransformUse use;
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < count; ++i) {
    draws.push_back(read_draw(place.child(i), context, use, findings));
    vertices += draws.back().vertices.size();
  }
  if (vertices > kMaxVertices)
    findings.add(place, fmt::format("a case has {} vertices", vertices),
                 fmt::format("write {} at most, over all draws", kMaxVertices));
  if (context.transform && findings.size() == before) check_use(*context.transform, use, findings);
  return draws;
}

}  // namespace edgecase
