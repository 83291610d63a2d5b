// SPDX-License-Identifier: MIT
#include "casefile/scene/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "casefile/scene/patterns.h"
#include "casefile/scene/samples.h"
#include "casefile/scene/viewport.h"
#include "exact/numeral.h"
#include "model/clipped_line.h"
#include "model/fnv.h"

namespace edgecase {

namespace {

// The float32 nearest to level / 255.
float component(std::uint64_t level) {
  return static_cast<float>(level) / 255.0F;
}

// The value of a channel at a hue, 0 to 255; hues are in 1/2^32 of a turn. It is full within a
// sixth of a turn of the channel's own hue `centre` and falls linearly to 0 over the next sixth.
std::uint64_t channel(std::uint32_t hue, std::uint32_t centre) {
  constexpr std::uint64_t kSixth = (std::uint64_t{1} << 32) / 6;
  const std::uint32_t forward = hue - centre;
  const std::uint64_t away = std::min(forward, std::uint32_t{0} - forward);
  if (away <= kSixth) return 255;
  if (away >= 2 * kSixth) return 0;
  return (2 * kSixth - away) * 255 / kSixth;
}

constexpr std::uint64_t kGoldenTurn = 0x9E3779B9;  // 2^32 / golden ratio

// Whether the hues of two colours, `steps` apart, differ by at least a sixth of a turn.
bool hues_differ(std::uint64_t steps) {
  constexpr std::uint32_t kSixth = 0x2AAAAAAA;  // 2^32 / 6
  const auto turn = static_cast<std::uint32_t>(steps * kGoldenTurn);
  return std::min(turn, std::uint32_t{0} - turn) >= kSixth;
}

}  // namespace

std::uint64_t hash_of_id(std::string_view id) {
  return mix(fnv_of(id));
}

Color salted_clear(std::uint64_t hash) {
  return {component(hash & 63), component((hash >> 6) & 63), component((hash >> 12) & 63), 1};
}

Color salted_primitive(std::uint64_t hash, std::uint64_t primitive) {
  constexpr std::uint32_t kThird = 0x55555555;  // 2^32 / 3
  const auto hue = static_cast<std::uint32_t>((hash >> 32) + primitive * kGoldenTurn);
  const std::uint64_t salt = mix(hash + primitive + 1);
  const std::uint64_t peak = 192 + (salt & 63);
  constexpr std::uint64_t kFloor = 64;  // so that every channel matters
  Color color{0, 0, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t level =
        kFloor + channel(hue, kThird * static_cast<std::uint32_t>(i)) * (peak - kFloor) / 255;
    const std::uint64_t noise = (salt >> (8 + 3 * i)) & 7;
    color[i] = component((level & ~std::uint64_t{7}) | noise);
  }
  return color;
}

std::vector<std::uint64_t> salted_indices(Primitive primitive, std::size_t vertices) {
  const auto each = static_cast<std::size_t>(vertices_of(kind_of(primitive)));
  const bool shared = is_vertex_count(primitive, each + 1) && each > 1;
  std::vector<std::uint64_t> indices;
  indices.reserve(vertices);
  for (std::size_t i = 0; i < vertices; ++i) indices.push_back(shared ? i : i / each);
  if (primitive != Primitive::line_loop || vertices < 2) return indices;
  // A loop's last vertex has two neighbours: the one before it and the first.
  std::uint64_t& last = indices.back();
  const std::uint64_t before = indices[vertices - 2];
  while (!hues_differ(last) || !hues_differ(last - before)) ++last;
  return indices;
}

namespace {

// The draws' vertices, with derived colours where the file gives none. Vertices of textured draws
// need none and stay white.
std::vector<Draw> fill_colors(const std::vector<DrawFields>& draws, std::uint64_t hash) {
  std::vector<Draw> result;
  std::uint64_t colors_before = 0;
  for (const DrawFields& fields : draws) {
    Draw draw = fields.draw;
    draw.vertices.reserve(fields.vertices.size());
    const auto indices = salted_indices(draw.primitive, fields.vertices.size());
    for (std::size_t i = 0; i < fields.vertices.size(); ++i) {
      Vertex vertex = fields.vertices[i].vertex;
      if (!fields.vertices[i].has_color && !draw.texture)
        vertex.color = salted_primitive(hash, colors_before + indices[i]);
      draw.vertices.push_back(vertex);
    }
    if (!indices.empty()) colors_before += indices.back() + 1;
    result.push_back(std::move(draw));
  }
  return result;
}

// One axis of a viewport, and the factor of a vertex's coordinates along it.
struct Axis {
  char name = 'x';
  ViewportSide side;
  float w = 1;
};

void check_coordinate(const std::optional<Place>& place, const std::optional<Inexactness>& fault,
                      Findings& findings) {
  if (place && fault) findings.add(*place, fault->message, fault->remedy);
}

// Checks a coordinate as moved by each pass; returns the first fault, if any.
std::optional<Inexactness> find_moved_inexactness(Fixed coordinate,
                                                  const std::vector<Fixed>& shifts,
                                                  const Axis& axis) {
  for (const Fixed shift : shifts) {
    const Fixed moved = coordinate + shift;
    auto fault = find_inexactness(moved, axis.side, axis.name, axis.w);
    if (!fault && !moved.in_coordinate_range())
      fault = Inexactness{fmt::format("{} = {}, out of range", axis.name, to_decimal(moved)),
                          "move the vertex nearer to the target"};
    if (!fault) continue;
    if (shift != Fixed())
      fault->message = fmt::format("moved by {} for a pass of \"supersample\", {}",
                                   to_decimal(shift), fault->message);
    return fault;
  }
  return std::nullopt;
}

// Checks that a vertex in window coordinates reaches OpenGL as written, in each pass.
void check_exactness(const VertexFields& fields, const Shifts& shifts, const Viewport& viewport,
                     Findings& findings) {
  const Vertex& vertex = fields.vertex;
  const Point at = vertex.position;
  const Axis columns{'x', {viewport.x, viewport.width}, vertex.w};
  const Axis rows{'y', {viewport.y, viewport.height}, vertex.w};
  check_coordinate(fields.x, find_moved_inexactness(at.x, shifts.x, columns), findings);
  check_coordinate(fields.y, find_moved_inexactness(at.y, shifts.y, rows), findings);
  check_coordinate(fields.z, find_depth_inexactness(vertex.z, vertex.w), findings);
}

// Checks that in each pass clip coordinates stay in the clip volume, and window positions in range.
bool check_passes(const Place& place, const Vertex& vertex, const Scene& scene,
                  Findings& findings) {
  for (const ShadingPass& pass : scene.supersampling) {
    const Point shift = shift_of(pass);
    const Vertex moved = moved_vertex(vertex, shift, scene.viewport);
    auto fault =
        find_volume_fault(*moved.clip, fmt::format("the vertex, moved by ({}, {}) for a pass of "
                                                   "\"supersample\",",
                                                   to_decimal(shift.x), to_decimal(shift.y)));
    if (!fault && !is_in_range(moved))
      fault = Inexactness{fmt::format("a pass of \"supersample\" moves the vertex to ({}, {}), "
                                      "out of range",
                                      to_decimal(moved.position.x), to_decimal(moved.position.y)),
                          "move the vertex nearer to the target"};
    if (!fault) continue;
    findings.add(place, fault->message, fault->remedy);
    return false;
  }
  return true;
}

// Computes the window position of clip coordinates; false, and a finding, if it is out of range.
bool place_vertex(const Place& place, const Viewport& viewport, Vertex& vertex,
                  Findings& findings) {
  place_clip_vertex(viewport, vertex);
  const Point at = vertex.position;
  if (at.x.in_coordinate_range() && at.y.in_coordinate_range()) return true;
  findings.add(
      place,
      fmt::format("the vertex lands at ({}, {}), out of range", to_decimal(at.x), to_decimal(at.y)),
      fmt::format("use a viewport within -{0} to {0}", Fixed::kMaxCoordinate));
  return false;
}

// Why a draw cannot have this vertex outside the clip volume; nothing if it can.
std::optional<Inexactness> find_clipping_fault(const Vertex& vertex, bool of_mesh, const Draw& draw,
                                               const Scene& scene) {
  const auto beyond =
      find_volume_fault(*vertex.clip, of_mesh ? "a vertex of the mesh" : "the vertex");
  if (!beyond) return std::nullopt;
  if (!scene.supersampling.empty())
    return Inexactness{beyond->message + "; supersampled scenes are not clipped", beyond->remedy};
  if (draw.interpolation == Interpolation::noperspective && !(vertex.w > 0))
    return Inexactness{beyond->message + ", from where nothing runs linearly in the window",
                       "interpolate smooth or flat"};
  if (!fits_clipping(scene.viewport))
    return Inexactness{
        beyond->message + ", and the viewport is too large to clip at",
        "use a viewport whose size and distance of its centre from 0, twice over, add up to at "
        "most 32768 pixels"};
  return std::nullopt;
}

// Whether a line is cut at a point that the model's quotients cannot represent.
bool is_cut_too_fine(const ScenePrimitive& line) {
  if (line.kind != PrimitiveKind::line || !line.is_clipped) return false;
  const RationalClip from = rational_clip(*line.vertices[0], line.viewport);
  const RationalClip to = rational_clip(*line.vertices[1], line.viewport);
  const auto part = visible_part(from, to);
  if (!part) return false;
  return !window_place(between(from, to, part->from), line.viewport) ||
         !window_place(between(from, to, part->to), line.viewport);
}

void check_cut_lines(const std::vector<DrawFields>& draws, const Scene& scene, Findings& findings) {
  for (const ScenePrimitive& line : primitives_of(scene)) {
    if (!is_cut_too_fine(line)) continue;
    const auto d = static_cast<std::size_t>(line.draw);
    const auto first = line.vertices[0] - scene.draws[d].vertices.data();
    findings.add(draws[d].vertices[static_cast<std::size_t>(first)].place,
                 "the line that starts here is cut at the clip volume, in a place that is no "
                 "quotient of integers up to 2^32",
                 "give its vertices rounder clip coordinates");
  }
}

void place_vertices(const std::vector<DrawFields>& draws, Scene& scene, Findings& findings) {
  const Shifts shifts = shifts_of(scene.supersampling);
  for (std::size_t d = 0; d < draws.size(); ++d) {
    for (std::size_t i = 0; i < draws[d].vertices.size(); ++i) {
      const VertexFields& fields = draws[d].vertices[i];
      if (!fields.vertex.clip) {
        check_exactness(fields, shifts, scene.viewport, findings);
        continue;
      }
      Vertex& vertex = scene.draws[d].vertices[i];
      if (const auto fault = find_clipping_fault(vertex, fields.of_mesh, scene.draws[d], scene)) {
        findings.add(fields.place, fault->message, fault->remedy);
        if (fields.of_mesh) break;
        continue;
      }
      const bool sound = place_vertex(fields.place, scene.viewport, vertex, findings) &&
                         check_passes(fields.place, vertex, scene, findings);
      if (!sound && fields.of_mesh) break;
    }
  }
}

}  // namespace

Scene complete_scene(const TargetFields& target, const std::vector<DrawFields>& draws,
                     const std::string& id, const Place& draws_place, Findings& findings) {
  const std::uint64_t hash = hash_of_id(id);
  Scene scene;
  scene.target = target.target;
  scene.target.clear = target.clear.value_or(salted_clear(hash));
  scene.depth_range = target.depth_range;
  scene.draws = fill_colors(draws, hash);
  scene.supersampling = target.supersampling;
  // Vertices of a faulty file have placeholder coordinates, which must not be judged.
  if (!findings.empty()) return scene;
  check_pass_work(scene, target, findings);
  if (!findings.empty()) return scene;
  const std::optional<Viewport> viewport =
      target.viewport ? target.viewport
                      : choose_viewport(scene.target, scene.draws, scene.supersampling);
  if (!viewport) {
    findings.add(draws_place,
                 "no viewport of at most 16384 pixels holds the target and all vertices",
                 "move the vertices closer together");
    return scene;
  }
  scene.viewport = *viewport;
  place_vertices(draws, scene, findings);
  if (findings.empty()) check_cut_lines(draws, scene, findings);
  if (findings.empty()) check_draw_work(scene, draws_place, findings);
  return scene;
}

}  // namespace edgecase
