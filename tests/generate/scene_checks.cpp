// SPDX-License-Identifier: MIT
#include "tests/generate/scene_checks.h"

#include <fmt/format.h>

#include <bit>

#include "casefile/scene/viewport.h"
#include "model/fnv.h"
#include "raster/rasterizer.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {
namespace {

// float32 arithmetic throughout, as OpenGL's viewport transform has it: window = clip * half + c.
bool arrives(Fixed coordinate, int origin, int size) {
  const double half = size / 2.0;
  const double centre = origin + half;
  const double quotient = (coordinate.to_double() - centre) / half;
  const auto clip = static_cast<float>(quotient);
  const float scaled = clip * static_cast<float>(half);
  const float window = scaled + static_cast<float>(centre);
  return static_cast<double>(clip) == quotient &&
         static_cast<double>(scaled) == coordinate.to_double() - centre &&
         static_cast<double>(window) == coordinate.to_double();
}

std::string fault_of_side(Fixed coordinate, int size, char axis) {
  const auto inexactness = find_inexactness(coordinate, {0, size}, axis);
  return inexactness ? inexactness->message : "";
}

// What OpenGL computes of clip coordinates: is one rounded on its way to them, or back to window
// coordinates?
std::string rounding_of(const Scene& scene) {
  const Viewport& viewport = scene.viewport;
  for (const Draw& draw : scene.draws)
    for (const Vertex& vertex : draw.vertices)
      if (!arrives(vertex.position.x, viewport.x, viewport.width) ||
          !arrives(vertex.position.y, viewport.y, viewport.height))
        return fmt::format("({}, {}) is rounded", vertex.position.x.to_double(),
                           vertex.position.y.to_double());
  return "";
}

CoverageChoice all_boundaries(const char* name) {
  CoverageChoice choice;
  choice.ties = *find_tie_rule(name);
  choice.line.boundary = find_diamond_boundary(name);
  return choice;
}

}  // namespace

std::string fault_of(const Scene& scene, int most) {
  const int size = scene.target.width;
  if (scene.target.height != size || size < 4 || size > most ||
      !std::has_single_bit(static_cast<unsigned>(size)))
    return fmt::format("target {}x{}", size, scene.target.height);
  const Viewport& viewport = scene.viewport;
  if (viewport.x != 0 || viewport.y != 0 || viewport.width != size || viewport.height != size)
    return "the viewport is not the target";
  for (const Draw& draw : scene.draws) {
    if (!is_vertex_count(draw.primitive, draw.vertices.size())) return "number of vertices";
    for (const Vertex& vertex : draw.vertices)
      for (std::string fault : {fault_of_side(vertex.position.x, size, 'x'),
                                fault_of_side(vertex.position.y, size, 'y')})
        if (!fault.empty()) return fault;
  }
  return rounding_of(scene);
}

bool has_tie(const Scene& scene, const SamplePositions& samples) {
  static const CoverageChoice open = all_boundaries("open");
  static const CoverageChoice closed = all_boundaries("closed");
  for (const ScenePrimitive& primitive : primitives_of(scene))
    if (covered_samples(primitive, scene.target, open, samples) !=
        covered_samples(primitive, scene.target, closed, samples))
      return true;
  return false;
}

std::uint64_t fingerprint_of(const Scene& scene) {
  std::uint64_t hash = kFnvStart;
  const auto add = [&](std::int64_t value) {
    hash = fnv_step(hash, static_cast<std::uint64_t>(value));
  };
  add(scene.target.width);
  add(static_cast<int>(scene.target.surface));
  for (const Draw& draw : scene.draws) {
    add(static_cast<int>(draw.primitive));
    add(static_cast<int>(draw.provoking_vertex));
    add(draw.line_width.raw());
    add(draw.point_size.raw());
    for (const Vertex& vertex : draw.vertices) {
      add(vertex.position.x.raw());
      add(vertex.position.y.raw());
      add(vertex.z.raw());
      for (float component : vertex.color) add(static_cast<std::int64_t>(component * 255.0f));
    }
  }
  return hash;
}

}  // namespace edgecase
