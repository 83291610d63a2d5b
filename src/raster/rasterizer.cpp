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

// Pixels whose centres can lie in a point's square, and some around it.
PixelBounds bounds_near(const SizedPoint& point, const PixelBounds& all) {
  const std::int64_t margin = point.size.ceil() / 2 + 1;
  const auto low = [&](int bound, Fixed at) {
    return static_cast<int>(std::max<std::int64_t>(bound, at.floor() - margin));
  };
  const auto high = [&](int bound, Fixed at) {
    return static_cast<int>(std::min<std::int64_t>(bound, at.floor() + margin));
  };
  return {low(all.x_min, point.vertex.x), low(all.y_min, point.vertex.y),
          high(all.x_max, point.vertex.x), high(all.y_max, point.vertex.y)};
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
  f.kind = primitive.kind;
  f.line_parameter = line_parameter;
  for (int i = 0; i < vertices_of(f.kind); ++i) {
    const auto index = static_cast<std::size_t>(i);
    f.positions[index] = primitive.vertices[index]->position;
    f.values[index] = value_of(*primitive.vertices[index]);
  }
  return f;
}

void write_pixel(Rendering& rendering, int x, int y, const std::array<double, 4>& color) {
  const std::size_t first = 4 * rendering.pixel_index(x, y);
  for (std::size_t i = 0; i < 4; ++i) rendering.pixels[first + i] = to_unorm8(color[i]);
}

std::vector<PixelPosition> point_pixels(const SizedPoint& point, const PixelBounds& bounds,
                                        const TieRule& ties) {
  const PixelBounds near = bounds_near(point, bounds);
  std::vector<PixelPosition> pixels;
  for (int y = near.y_min; y <= near.y_max; ++y)
    for (int x = near.x_min; x <= near.x_max; ++x)
      if (point_covers(point, x, y, ties)) pixels.push_back({x, y});
  return pixels;
}

// The pixels of a primitive whose vertices are where the choice has them, in no particular order.
std::vector<PixelPosition> pixels_of(const Draw& state, PrimitiveKind kind,
                                     const std::array<Point, 3>& p, const PixelBounds& bounds,
                                     const CoverageChoice& choice) {
  switch (kind) {
    case PrimitiveKind::point:
      return point_pixels({moved(p[0], choice.point_offset), state.point_size}, bounds,
                          choice.ties);
    case PrimitiveKind::line:
      return line_pixels({p[0], p[1]}, state.line_width, bounds, choice.line, choice.ties);
    case PrimitiveKind::triangle:
      return triangle_pixels(p, bounds, choice.triangle_algorithm, choice.ties);
  }
  return {};
}

}  // namespace

PixelBounds drawable_bounds(const Draw& draw, const Target& target) {
  PixelBounds bounds{0, 0, target.width - 1, target.height - 1};
  if (!draw.scissor) return bounds;
  const Viewport& scissor = *draw.scissor;
  bounds.x_min = std::max(bounds.x_min, scissor.x);
  bounds.y_min = std::max(bounds.y_min, scissor.y);
  bounds.x_max = std::min(bounds.x_max, scissor.x + scissor.width - 1);
  bounds.y_max = std::min(bounds.y_max, scissor.y + scissor.height - 1);
  return bounds;
}

std::vector<PixelPosition> covered_pixels(const ScenePrimitive& primitive, const Target& target,
                                          const CoverageChoice& choice) {
  const bool turned = choice.rows == RowOrder::top_down;
  PixelBounds bounds = drawable_bounds(*primitive.state, target);
  if (turned) bounds = turned_over(bounds, target.height);
  std::array<Point, 3> p{};
  const auto count = static_cast<std::size_t>(vertices_of(primitive.kind));
  for (std::size_t i = 0; i < count; ++i) {
    const Point given = primitive.vertices[i]->position;
    p[i] = choice.snap(turned ? turned_over(given, target.height) : given);
  }
  auto pixels = pixels_of(*primitive.state, primitive.kind, p, bounds, choice);
  if (turned)
    for (PixelPosition& pixel : pixels) pixel.y = target.height - 1 - pixel.y;
  std::sort(pixels.begin(), pixels.end(), row_first);
  return pixels;
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
  const Vertex& provoking = *primitive.vertices[provoking_index(primitive, choice.provoking)];
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
    const CoverageChoice& choice = choices.of(primitive.kind);
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
