// SPDX-License-Identifier: MIT
#include "generate/random_scenes.h"

#include "generate/random_shapes.h"
#include "raster/rasterizer.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {
namespace {

// Generators of one seed with different purposes are independent.
enum Stream : std::uint64_t {
  kPoints,
  kLines,
  kTriangles,
  kWideLines,
  kSharedEdges,
  kMultisampled = 0x5a00,  // plus a MultisampledKind
};

Scene random_point_scene(RandomSource& random, Surface surface) {
  const Frame frame = random_frame(random);
  const RandomPoint point = random_point_shape(random, frame);
  Scene scene = scene_of(surface, frame.target, Primitive::points, {&point.vertex, 1});
  scene.draws[0].point_size = point.size;
  return scene;
}

Scene random_line_scene(RandomSource& random, Surface surface) {
  const Frame frame = random_frame(random);
  return scene_of(surface, frame.target, Primitive::lines, random_line_shape(random, frame));
}

Scene random_triangle_scene(RandomSource& random, Surface surface) {
  const Frame frame = random_frame(random);
  return scene_of(surface, frame.target, Primitive::triangles,
                  random_triangle_shape(random, frame));
}

// 1.25 to 16 pixels, raw.
std::int64_t random_width(RandomSource& random) {
  return random.between(5, 64) * Fixed::kOne / 4;
}

CoverageChoice all_boundaries(const char* name) {
  CoverageChoice choice;
  choice.ties = *find_tie_rule(name);
  choice.line.boundary = find_diamond_boundary(name);
  return choice;
}

}  // namespace

Scene random_scene(const PrimitiveScenes& of, std::uint64_t index) {
  switch (of.kind) {
    case PrimitiveKind::point: {
      RandomSource random(of.seed, kPoints, index);
      return random_point_scene(random, of.surface);
    }
    case PrimitiveKind::line: {
      RandomSource random(of.seed, kLines, index);
      return random_line_scene(random, of.surface);
    }
    case PrimitiveKind::triangle:
      break;
  }
  RandomSource random(of.seed, kTriangles, index);
  return random_triangle_scene(random, of.surface);
}

Scene random_wide_line(std::uint64_t seed, Surface surface, std::uint64_t index) {
  RandomSource random(seed, kWideLines, index);
  Scene scene = random_line_scene(random, surface);
  scene.draws[0].line_width = Fixed::from_raw(random_width(random));
  return scene;
}

Scene shared_edge_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  RandomSource random(seed, kSharedEdges, index);
  const Frame frame = random_frame(random);
  Scene scene =
      scene_of(surface, frame.target, Primitive::triangles, random_pair_shape(random, frame));
  // One colour per triangle.
  std::vector<Vertex>& vertices = scene.draws[0].vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].color = vertices[i / 3 * 3].color;
  return scene;
}

Scene random_multisampled_scene(std::uint64_t seed, MultisampledKind kind,
                                const SamplePositions& samples, std::uint64_t index) {
  RandomSource random(seed, kMultisampled + static_cast<std::uint64_t>(kind), index);
  const Frame frame = random_frame(random, kMostMultisampledTarget);
  const Point tied = random.one_of(std::span<const Point>(samples));
  Scene scene;
  if (kind == MultisampledKind::triangle) {
    scene = scene_of(Surface::fbo, frame.target, Primitive::triangles,
                     random_triangle_shape(random, frame, tied));
  } else {
    const bool is_wide = kind == MultisampledKind::wide_line;
    const std::int64_t width = is_wide ? random_width(random) : Fixed::kOne;
    scene = scene_of(Surface::fbo, frame.target, Primitive::lines,
                     random_area_line_shape(random, frame, width, tied));
    scene.draws[0].line_width = Fixed::from_raw(width);
  }
  scene.target.samples = static_cast<int>(samples.size());
  return scene;
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

}  // namespace edgecase
