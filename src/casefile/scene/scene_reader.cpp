// SPDX-License-Identifier: MIT
#include "casefile/scene/scene_reader.h"

#include <fmt/format.h>

#include "casefile/mesh/mesh.h"
#include "casefile/mesh/transform.h"
#include "casefile/scene/fragment_operations.h"
#include "casefile/scene/plain_fields.h"
#include "casefile/scene/samples.h"
#include "casefile/scene/textures.h"
#include "casefile/scene/viewport.h"

namespace edgecase {

namespace {

Keys target_keys() {
  Keys keys{required_keys<Target>(),
            {"samples", "sample_positions", "depth", "clear", "viewport", "y", "supersample"},
            {}};
  for (std::string& name : plain_keys<Target>()) keys.optional.push_back(std::move(name));
  for (std::string& name : target_operation_keys()) keys.optional.push_back(std::move(name));
  return keys;
}
const Keys kRectangleKeys{{"x", "y", "width", "height"}, {}, {}};

void read_into(const ObjectReader& object, const char* name, IntegerRange range, Findings& findings,
               int& value) {
  const auto place = object.find(name);
  if (!place) return;
  value = read_integer(*place, name, range, findings).value_or(value);
}

}  // namespace

std::optional<Viewport> read_rectangle(const Place& place, std::string_view what, int least_size,
                                       Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, what, kRectangleKeys, findings);
  Viewport rectangle;
  read_into(object, "x", {-kMaxViewportSize, kMaxViewportSize}, findings, rectangle.x);
  read_into(object, "y", {-kMaxViewportSize, kMaxViewportSize}, findings, rectangle.y);
  read_into(object, "width", {least_size, kMaxViewportSize}, findings, rectangle.width);
  read_into(object, "height", {least_size, kMaxViewportSize}, findings, rectangle.height);
  if (findings.size() != before) return std::nullopt;
  return rectangle;
}

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
  Keys keys{{}, plain_keys<Draw>(), {}};
  for (const char* name : {"scissor", "texture", "sampler", "lookup"})
    keys.optional.emplace_back(name);
  for (std::string& name : multisampling_keys()) keys.optional.push_back(std::move(name));
  for (std::string& name : fragment_operation_keys()) keys.optional.push_back(std::move(name));
  return keys;
}

constexpr Float32Range kColorRange{-kMaxColor, kMaxColor};

TextureState read_state(const Place& place, const DrawContext& context, Draw& draw,
                        Findings& findings) {
  static const Keys kStateKeys = state_keys();
  const ObjectReader object(place, "a state", kStateKeys, findings);
  read_fields(object, findings, draw);
  if (const auto scissor = object.find("scissor"))
    draw.scissor = read_rectangle(*scissor, "a scissor", 0, findings);
  draw.multisampling = read_multisampling(object, context.target.target.samples, findings);
  read_fragment_operations(object, context.target, draw, findings);
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
