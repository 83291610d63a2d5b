// SPDX-License-Identifier: MIT
#include "raster/rasterizer.h"

#include <algorithm>
#include <span>
#include <tuple>

#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/values/flat_attribute.h"
#include "rules/values/smooth_attribute.h"

namespace edgecase {
namespace {

PixelBounds bounds_of(const Target& target) {
  return {0, 0, target.width - 1, target.height - 1};
}

// Pixels whose centres can lie within the hull of the positions grown by one pixel.
PixelBounds bounds_of(std::span<const Point> positions, const PixelBounds& target) {
  PixelBounds result = target;
  const auto [x_low, x_high] = std::minmax_element(positions.begin(), positions.end(),
                                                   [](Point a, Point b) { return a.x < b.x; });
  const auto [y_low, y_high] = std::minmax_element(positions.begin(), positions.end(),
                                                   [](Point a, Point b) { return a.y < b.y; });
  result.x_min = static_cast<int>(std::max<std::int64_t>(target.x_min, x_low->x.floor() - 1));
  result.x_max = static_cast<int>(std::min<std::int64_t>(target.x_max, x_high->x.floor() + 1));
  result.y_min = static_cast<int>(std::max<std::int64_t>(target.y_min, y_low->y.floor() - 1));
  result.y_max = static_cast<int>(std::min<std::int64_t>(target.y_max, y_high->y.floor() + 1));
  return result;
}

template <class Covers>
std::vector<PixelPosition> collect(const PixelBounds& bounds, Covers covers) {
  std::vector<PixelPosition> result;
  for (int y = bounds.y_min; y <= bounds.y_max; ++y)
    for (int x = bounds.x_min; x <= bounds.x_max; ++x)
      if (covers(x, y)) result.push_back({x, y});
  return result;
}

bool row_first(PixelPosition a, PixelPosition b) {
  return std::tie(a.y, a.x) < std::tie(b.y, b.x);
}

// The double nearest to the middle: the interval is narrower than what any format can hold.
double middle(Interval value) {
  return value.low / 2 + value.high / 2;
}

template <class ValueOf>
Interpolant make_interpolant(const ScenePrimitive& primitive, LineParameter line_parameter,
                             ValueOf value_of) {
  Interpolant f;
  f.primitive = primitive.state->primitive;
  f.line_parameter = line_parameter;
  for (int i = 0; i < vertices_per_primitive(f.primitive); ++i) {
    const auto index = static_cast<std::size_t>(i);
    f.positions[index] = primitive.vertices[i].position;
    f.values[index] = value_of(primitive.vertices[i]);
  }
  return f;
}

void write_pixel(Rendering& rendering, int x, int y, const std::array<double, 4>& color) {
  std::uint8_t* pixel = rendering.pixels.data() + 4 * rendering.pixel_index(x, y);
  for (std::size_t i = 0; i < 4; ++i) pixel[i] = to_unorm8(color[i]);
}

}  // namespace

std::vector<PixelPosition> covered_pixels(const ScenePrimitive& primitive, const Target& target,
                                          const CoverageChoice& choice) {
  const PixelBounds all = bounds_of(target);
  std::array<Point, 3> p{};
  const int count = vertices_per_primitive(primitive.state->primitive);
  for (int i = 0; i < count; ++i)
    p[static_cast<std::size_t>(i)] = choice.snap(primitive.vertices[i].position);
  const PixelBounds bounds = bounds_of(std::span(p).first(static_cast<std::size_t>(count)), all);

  switch (primitive.state->primitive) {
    case Primitive::points:
      return collect(bounds, [&](int x, int y) { return point_covers(p[0], x, y, choice.ties); });
    case Primitive::lines: {
      auto pixels = diamond_exit_pixels({p[0], p[1]}, all, choice.ties);
      std::sort(pixels.begin(), pixels.end(), row_first);
      return pixels;
    }
    case Primitive::triangles:
      return collect(bounds, [&](int x, int y) { return triangle_covers(p, x, y, choice.ties); });
  }
  return {};
}

Interpolant color_interpolant(const ScenePrimitive& primitive, std::size_t component,
                              LineParameter line_parameter) {
  return make_interpolant(primitive, line_parameter, [&](const Vertex& vertex) {
    return static_cast<double>(vertex.color[component]);
  });
}

Interpolant depth_interpolant(const ScenePrimitive& primitive, LineParameter line_parameter) {
  return make_interpolant(primitive, line_parameter,
                          [](const Vertex& vertex) { return (vertex.z.to_double() + 1) / 2; });
}

Fragment shade(const ScenePrimitive& primitive, PixelPosition pixel, const ValueChoice& choice) {
  const Draw& draw = *primitive.state;
  const Point sample = pixel_centre(pixel.x, pixel.y);
  const LineParameter parameter = choice.line_parameter;
  Fragment fragment;
  fragment.x = pixel.x;
  fragment.y = pixel.y;
  fragment.primitive = primitive.index;
  fragment.depth = middle(interpolate_exact(depth_interpolant(primitive, parameter), sample));
  const Vertex& provoking = primitive.vertices[provoking_index(draw, choice.provoking)];
  for (std::size_t c = 0; c < 4; ++c)
    fragment.color[c] =
        draw.interpolation == Interpolation::flat
            ? static_cast<double>(provoking.color[c])
            : middle(interpolate_exact(color_interpolant(primitive, c, parameter), sample));
  return fragment;
}

Rendering rasterize(const Scene& scene, const Policy& policy) {
  const RuleChoices choices = resolve(policy, scene.target.surface);
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  rendering.samples = scene.target.samples;
  const auto pixels =
      static_cast<std::size_t>(rendering.width) * static_cast<std::size_t>(rendering.height);
  rendering.pixels.resize(4 * pixels);
  rendering.hits.resize(pixels);

  // Clear, then let each fragment overwrite what was there: drawing order is all that counts.
  std::array<double, 4> clear{};
  std::copy(scene.target.clear.begin(), scene.target.clear.end(), clear.begin());
  for (int y = 0; y < rendering.height; ++y)
    for (int x = 0; x < rendering.width; ++x) write_pixel(rendering, x, y, clear);
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const CoverageChoice& choice = choices.of(primitive.state->primitive);
    for (PixelPosition pixel : covered_pixels(primitive, scene.target, choice)) {
      const Fragment fragment = shade(primitive, pixel, choices.values);
      write_pixel(rendering, pixel.x, pixel.y, fragment.color);
      ++rendering.hits[rendering.pixel_index(pixel.x, pixel.y)];
      rendering.fragments.push_back(fragment);
    }
  }
  sort_fragments(rendering);
  return rendering;
}

}  // namespace edgecase
