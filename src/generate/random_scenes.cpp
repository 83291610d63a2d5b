// SPDX-License-Identifier: MIT
#include "generate/random_scenes.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "generate/random_shapes.h"

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

namespace {

// Generators of one seed with different purposes are independent.
constexpr std::uint64_t kStreams = 0x5e00;  // plus an OutputKind

// Mostly comparisons that pass some fragments and reject others.
constexpr std::array kFunctions{CompareFunction::less,     CompareFunction::less,
                                CompareFunction::lequal,   CompareFunction::greater,
                                CompareFunction::gequal,   CompareFunction::equal,
                                CompareFunction::notequal, CompareFunction::always};

template <class Enum>
Enum any_of(RandomSource& random, Enum last) {
  return static_cast<Enum>(random.below(static_cast<std::int64_t>(last) + 1));
}

// z for one of few depths, or any.
Fixed random_z(RandomSource& random) {
  const std::int64_t steps = random.one_in(3) ? 8 : Fixed::kOne;
  return Fixed::from_raw(random.between(-steps, steps) * (Fixed::kOne / steps));
}

Draw random_triangle(RandomSource& random, const Frame& of) {
  Frame frame = of;
  frame.extent = random.between(Fixed::kOne, frame.most);
  const Color color = random_color(random);
  const bool is_level = random.one_in(3);
  const Fixed level = random_z(random);
  Draw draw;
  draw.primitive = Primitive::triangles;
  for (const Point& corner : random_triangle_shape(random, frame))
    draw.vertices.push_back({corner, is_level ? level : random_z(random), color});
  return draw;
}

// A term whose factors drivers support for the destination without an extension.
BlendTerm random_term(RandomSource& random) {
  return {any_of(random, BlendEquation::max), any_of(random, BlendFactor::src_alpha_saturate),
          any_of(random, BlendFactor::one_minus_constant_alpha)};
}

StencilFace random_face(RandomSource& random) {
  StencilFace face;
  face.function = any_of(random, CompareFunction::always);
  face.reference = static_cast<std::uint8_t>(random.below(256));
  if (random.one_in(2)) face.read_mask = static_cast<std::uint8_t>(random.below(256));
  if (random.one_in(2)) face.write_mask = static_cast<std::uint8_t>(random.below(256));
  face.fail = any_of(random, StencilOperation::invert);
  face.depth_fail = any_of(random, StencilOperation::invert);
  face.pass = any_of(random, StencilOperation::invert);
  return face;
}

void set_depth_test(RandomSource& random, Draw& draw) {
  draw.operations.depth.function = random.one_of(std::span<const CompareFunction>(kFunctions));
  draw.operations.depth.write = !random.one_in(4);
}

PolygonOffset random_offset(RandomSource& random) {
  const auto share = [&] { return static_cast<float>(random.between(-8, 8)) / 4.0F; };
  const float factor = random.one_in(2) ? 0 : share();
  return {factor, 8 * share(), 0};
}

void add_draws(RandomSource& random, OutputKind kind, const Frame& frame,
               std::vector<Draw>& draws) {
  Draw draw = random_triangle(random, frame);
  switch (kind) {
    case OutputKind::depth_tested:
      set_depth_test(random, draw);
      break;
    case OutputKind::blended: {
      Blending blending{random_term(random), random_term(random), {}};
      for (float& component : blending.constant) component = random_color_component(random);
      draw.operations.blending = blending;
      for (bool& mask : draw.operations.color_mask) mask = !random.one_in(8);
      break;
    }
    case OutputKind::offset: {
      draws.push_back(draw);
      for (Vertex& vertex : draw.vertices) vertex.color = {1, 1, 1, 1};
      set_depth_test(random, draw);
      draw.polygon_offset = random_offset(random);
      break;
    }
    case OutputKind::stencilled:
      draw.operations.stencil = StencilTest{random_face(random), random_face(random)};
      set_depth_test(random, draw);
      break;
  }
  draws.push_back(std::move(draw));
}

}  // namespace

Scene random_output_scene(const RandomOutputScenes& of, std::uint64_t index) {
  RandomSource random(
      of.seed, kStreams + static_cast<std::uint64_t>(of.kind) + window_streams(of.surface), index);
  const Frame frame = random_frame(random, kMostMultisampledTarget);
  Scene scene = empty_scene(of.surface, frame.target);
  if (of.kind == OutputKind::blended)
    for (float& component : scene.target.clear)
      component = static_cast<float>(random.below(256)) / 255.0F;
  else
    scene.target.depth = of.depth;
  if (of.kind == OutputKind::stencilled) {
    scene.target.stencil = StencilFormat::stencil8;
    scene.target.clear_stencil = static_cast<std::uint8_t>(random.below(256));
  }
  const std::int64_t triangles = random.between(2, 6);
  for (std::int64_t i = 0; i < triangles; ++i) add_draws(random, of.kind, frame, scene.draws);
  return scene;
}

}  // namespace edgecase
