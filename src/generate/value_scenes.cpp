// SPDX-License-Identifier: MIT
#include "generate/value_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "casefile/scene/viewport.h"
#include "generate/random_shapes.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kStreams = 0x140;  // one for each mode

constexpr std::array<ValueMode, 10> kModes = {
    {{PrimitiveKind::triangle, Interpolation::smooth, false},
     {PrimitiveKind::triangle, Interpolation::smooth, true},
     {PrimitiveKind::triangle, Interpolation::noperspective, false},
     {PrimitiveKind::triangle, Interpolation::noperspective, true},
     {PrimitiveKind::triangle, Interpolation::flat, false},
     {PrimitiveKind::line, Interpolation::smooth, false},
     {PrimitiveKind::line, Interpolation::smooth, true},
     {PrimitiveKind::line, Interpolation::noperspective, false},
     {PrimitiveKind::line, Interpolation::noperspective, true},
     {PrimitiveKind::line, Interpolation::flat, false}}};

std::uint64_t stream_of(const ValueScenes& of) {
  const ValueMode& mode = of.mode;
  return kStreams + window_streams(of.surface) + 16 * static_cast<std::uint64_t>(mode.kind) +
         4 * static_cast<std::uint64_t>(mode.interpolation) + (mode.perspective ? 1 : 0);
}

double power_of_two(std::int64_t exponent) {
  return std::ldexp(1.0, static_cast<int>(exponent));
}

// One component at each vertex of a primitive.
std::array<float, 3> random_component(RandomSource& random) {
  const std::int64_t kind = random.below(8);
  const double base = random.fraction();
  std::array<float, 3> values{};
  for (std::size_t v = 0; v < values.size(); ++v) {
    double value = random.fraction();
    switch (kind) {
      case 2:  // beyond 0 to 1
        value *= static_cast<double>(random.sign() * random.log_uniform(10));
        break;
      case 3:  // through zero
        value *= v % 2 == 0 ? -1 : 1;
        break;
      case 4:  // a tiny range
        value = base + value * 0x1p-16;
        break;
      case 5:  // a huge one
        value = static_cast<double>(random.sign()) * (1 + value) *
                power_of_two(random.between(-40, 40));
        break;
      case 6:  // tiny numbers
        value *= static_cast<double>(random.sign()) * 0x1p-40;
        break;
      case 7:
        value = base;
        break;
      default:  // in 0 to 1
        break;
    }
    values[v] = static_cast<float>(value);
  }
  return values;
}

void set_colors(RandomSource& random, std::span<Vertex> primitive) {
  for (std::size_t c = 0; c < 4; ++c) {
    const auto values = random_component(random);
    for (std::size_t v = 0; v < primitive.size(); ++v) primitive[v].color[c] = values[v];
  }
}

constexpr std::array<std::int64_t, 6> kOddFactors{1, 1, 1, 3, 5, 7};

// Whether the clip coordinates of a vertex with this w are float32 numbers.
bool reaches_exactly(const Vertex& vertex, const Viewport& viewport, float w) {
  return !find_inexactness(vertex.position.x, {viewport.x, viewport.width}, 'x', w) &&
         !find_inexactness(vertex.position.y, {viewport.y, viewport.height}, 'y', w) &&
         !find_depth_inexactness(vertex.z, w);
}

// A w from 2^-octaves to 2^octaves with which the vertex stays exact.
float random_w(RandomSource& random, const Vertex& vertex, const Viewport& viewport, int octaves) {
  const double power = power_of_two(random.between(-octaves, octaves));
  const auto odd = static_cast<double>(random.one_of<std::int64_t>(kOddFactors));
  const auto w = static_cast<float>(power * odd);
  return reaches_exactly(vertex, viewport, w) ? w : static_cast<float>(power);
}

// Ratios: mild, up to 2^8, up to 2^16; times 7.
void set_w(RandomSource& random, const Viewport& viewport, bool perspective,
           std::span<Vertex> primitive) {
  if (!perspective) {
    if (!random.one_in(4)) return;
    const float w = static_cast<float>(power_of_two(random.between(-4, 4)));
    for (Vertex& vertex : primitive) vertex.w = w;
    return;
  }
  constexpr std::array<int, 3> kOctaves{1, 4, 8};
  const int octaves = random.one_of<int>(kOctaves);
  do {
    for (Vertex& vertex : primitive) vertex.w = random_w(random, vertex, viewport, octaves);
  } while (std::all_of(primitive.begin(), primitive.end(),
                       [&](const Vertex& vertex) { return vertex.w == primitive[0].w; }));
}

void set_depths(RandomSource& random, std::span<Vertex> primitive) {
  for (Vertex& vertex : primitive)
    vertex.z = Fixed::from_raw(random.between(-Fixed::kOne + 1, Fixed::kOne - 1));
}

// Some are large and have most of the fragments.
Frame value_frame(RandomSource& random) {
  Frame frame = random_frame(random);
  if (!random.one_in(8)) return frame;
  frame.target = 256;
  frame.most = 255 * Fixed::kOne - Fixed::kOne / 4;
  frame.extent = random.between(128, 254) * Fixed::kOne;
  return frame;
}

bool has_extent(std::span<const Point> points) {
  if (points.size() == 2) return !(points[0] == points[1]);
  return turn(points[1] - points[0], points[2] - points[0]) != 0;
}

std::vector<Point> shape_of(RandomSource& random, const Frame& frame, PrimitiveKind kind) {
  for (;;) {
    std::vector<Point> points = kind == PrimitiveKind::line ? random_line_shape(random, frame)
                                                            : random_triangle_shape(random, frame);
    if (has_extent(points)) return points;
  }
}

}  // namespace

std::span<const ValueMode> all_value_modes() {
  return kModes;
}

Scene value_scene(const ValueScenes& of, std::uint64_t index) {
  RandomSource random(of.seed, stream_of(of), index);
  const ValueMode& mode = of.mode;
  const bool line = mode.kind == PrimitiveKind::line;
  const Frame frame = value_frame(random);
  std::vector<Point> points;
  for (int i = 0; i < (line ? kLinesPerScene : 1); ++i)
    for (Point point : shape_of(random, frame, mode.kind)) points.push_back(point);
  Scene scene =
      scene_of(of.surface, frame.target, line ? Primitive::lines : Primitive::triangles, points);
  scene.details.coordinates =
      mode.perspective && mode.interpolation == Interpolation::noperspective;
  Draw& draw = scene.draws[0];
  draw.interpolation = mode.interpolation;
  draw.provoking_vertex = random.one_in(2) ? ProvokingVertex::first : ProvokingVertex::last;
  const auto each = static_cast<std::size_t>(vertices_of(mode.kind));
  for (std::size_t first = 0; first < draw.vertices.size(); first += each) {
    const std::span<Vertex> primitive(&draw.vertices[first], each);
    set_colors(random, primitive);
    set_depths(random, primitive);
    set_w(random, scene.viewport, mode.perspective, primitive);
  }
  return scene;
}

}  // namespace edgecase
