// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "casefile/numbers.h"
#include "casefile/scene_reader.h"

namespace edgecase {
namespace {

const Keys kDrawKeys{{"primitive", "vertices"}, {"state", "color"}, {}};
const Keys kStateKeys{
    {},
    {"interpolation", "provoking_vertex", "line_width", "point_size", "scissor"},
    {"texture", "sampler", "depth", "stencil", "blend", "cull", "polygon_offset", "sample_mask"}};
const Keys kVertexKeys{{"at"}, {"color"}, {"uv", "attributes"}};

const Names kPrimitiveNames{
    {"points", "lines", "line_strip", "line_loop", "triangles", "triangle_strip", "triangle_fan"},
    {}};

constexpr FixedRange kWindowRange{Fixed::from_integer(-Fixed::kMaxCoordinate),
                                  Fixed::from_integer(Fixed::kMaxCoordinate)};
// Widths of lines and sizes of points, pixels: every multiple of 2^-16 above 0.
constexpr FixedRange kSizeRange{Fixed::from_raw(1), Fixed::from_integer(64)};
constexpr FixedRange kDepthRange{Fixed::from_integer(-1), Fixed::from_integer(1)};

// [x, y], [x, y, z] or [x, y, z, w].
void read_position(const Place& place, Findings& findings, VertexFields& fields) {
  if (!expect_kind(place, JsonKind::array, "a vertex's position", findings)) return;
  const std::size_t count = place.node->children.size();
  if (count < 2 || count > 4) {
    findings.add(place, fmt::format("a vertex takes 2 to 4 coordinates, and this has {}", count),
                 "write [x, y], [x, y, z] or [x, y, z, 1]");
    return;
  }
  Vertex& vertex = fields.vertex;
  fields.x = place.child(0);
  fields.y = place.child(1);
  vertex.position.x = read_coordinate(*fields.x, "x", kWindowRange, findings).value_or(Fixed());
  vertex.position.y = read_coordinate(*fields.y, "y", kWindowRange, findings).value_or(Fixed());
  if (count > 2)
    vertex.z = read_coordinate(place.child(2), "z", kDepthRange, findings).value_or(Fixed());
  if (count < 4) return;
  const Place w_place = place.child(3);
  const auto w = read_coordinate(w_place, "w", kWindowRange, findings);
  if (w && *w != Fixed::from_integer(1))
    findings.add(w_place, "w other than 1 is not supported yet", "write 1, or leave w out");
}

VertexFields read_vertex(const Place& place, const std::optional<Color>& draw_color,
                         Findings& findings) {
  VertexFields fields;
  if (draw_color) {
    fields.vertex.color = *draw_color;
    fields.has_color = true;
  }
  if (place.node->kind != JsonKind::object) {
    if (place.node->kind == JsonKind::array) {
      read_position(place, findings, fields);
    } else {
      findings.add(
          place,
          fmt::format("a vertex must be an array or an object, not {}", describe(*place.node)),
          "write [x, y] or {\"at\": [x, y]}");
    }
    return fields;
  }
  const ObjectReader object(place, "a vertex", kVertexKeys, findings);
  if (const auto at = object.find("at")) read_position(*at, findings, fields);
  if (const auto color = object.find("color")) {
    fields.vertex.color =
        read_color(*color, "a vertex's colour", findings).value_or(fields.vertex.color);
    fields.has_color = true;
  }
  return fields;
}

void read_state(const Place& place, Draw& draw, Findings& findings) {
  const ObjectReader object(place, "a state", kStateKeys, findings);
  if (const auto interpolation = object.find("interpolation"))
    read_enum(*interpolation, "interpolation", {{"flat", "smooth", "noperspective"}, {}}, findings,
              draw.interpolation);
  if (const auto provoking = object.find("provoking_vertex"))
    read_enum(*provoking, "the provoking vertex", {{"first", "last"}, {}}, findings,
              draw.provoking_vertex);
  if (const auto width = object.find("line_width"))
    draw.line_width =
        read_coordinate(*width, "line_width", kSizeRange, findings).value_or(draw.line_width);
  if (const auto size = object.find("point_size"))
    draw.point_size =
        read_coordinate(*size, "point_size", kSizeRange, findings).value_or(draw.point_size);
  if (const auto scissor = object.find("scissor"))
    draw.scissor = read_rectangle(*scissor, "a scissor", 0, findings);
}

// `count` vertices make no whole primitives.
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
                   const std::optional<Color>& color, Findings& findings,
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
    vertices.push_back(read_vertex(place.child(i), color, findings));
}

DrawFields read_draw(const Place& place, Findings& findings) {
  DrawFields fields;
  const ObjectReader object(place, "a draw", kDrawKeys, findings);
  std::optional<Primitive> known;
  if (const auto primitive = object.find("primitive")) {
    if (read_enum(*primitive, "a primitive", kPrimitiveNames, findings, fields.draw.primitive))
      known = fields.draw.primitive;
  }
  if (const auto state = object.find("state")) read_state(*state, fields.draw, findings);
  std::optional<Color> color;
  if (const auto given = object.find("color"))
    color = read_color(*given, "a draw's colour", findings);
  if (const auto vertices = object.find("vertices"))
    read_vertices(*vertices, known, color, findings, fields.vertices);
  return fields;
}

}  // namespace

std::vector<DrawFields> read_draws(const Place& place, Findings& findings) {
  std::vector<DrawFields> draws;
  if (!expect_kind(place, JsonKind::array, "the list of draws", findings)) return draws;
  const std::size_t count = place.node->children.size();
  if (count == 0 || count > kMaxDraws) {
    findings.add(place, fmt::format("a case has {} draws", count),
                 fmt::format("write 1 to {} draws", kMaxDraws));
  }
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < count; ++i) {
    draws.push_back(read_draw(place.child(i), findings));
    vertices += draws.back().vertices.size();
  }
  if (vertices > kMaxVertices)
    findings.add(place, fmt::format("a case has {} vertices", vertices),
                 fmt::format("write {} at most, over all draws", kMaxVertices));
  return draws;
}

}  // namespace edgecase
