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

// Pixels whose centres can lie within the hull of the positions grown by half a size and one pixel.
PixelBounds bounds_near(std::span<const Point> positions, Fixed size, const PixelBounds& all) {
  Point low = positions[0];
  Point high = positions[0];
  for (Point p : positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const std::int64_t margin = size.ceil() / 2 + 1;
  const auto clip = [](std::int64_t value) {
    return static_cast<int>(
        std::clamp<std::int64_t>(value, -Fixed::kMaxCoordinate * 2, Fixed::kMaxCoordinate * 2));
  };
  return {std::max(all.x_min, clip(low.x.floor() - margin)),
          std::max(all.y_min, clip(low.y.floor() - margin)),
          std::min(all.x_max, clip(high.x.floor() + margin)),
          std::min(all.y_max, clip(high.y.floor() + margin))};
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

// A line with the rows of the target in the order that the choice says.
std::vector<PixelPosition> line_in_rows(const Segment& segment, Fixed width,
                                        const PixelBounds& bounds, int height,
                                        const CoverageChoice& choice) {
  if (choice.line.rows == RowOrder::bottom_up)
    return line_pixels(segment, width, bounds, choice.line, choice.ties);
  auto pixels = line_pixels(turned_over(segment, height), width, turned_over(bounds, height),
                            choice.line, choice.ties);
  for (PixelPosition& pixel : pixels) pixel.y = height - 1 - pixel.y;
  return pixels;
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
  std::uint8_t* pixel = rendering.pixels.data() + 4 * rendering.pixel_index(x, y);
  for (std::size_t i = 0; i < 4; ++i) pixel[i] = to_unorm8(color[i]);
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
  const PixelBounds all = drawable_bounds(*primitive.state, target);
  std::array<Point, 3> p{};
  const auto count = static_cast<std::size_t>(vertices_of(primitive.kind));
  for (std::size_t i = 0; i < count; ++i) p[i] = choice.snap(primitive.vertices[i]->position);

  switch (primitive.kind) {
    case PrimitiveKind::point: {
      const SizedPoint point{p[0], primitive.state->point_size};
      return collect(bounds_near({p.data(), count}, point.size, all),
                     [&](int x, int y) { return point_covers(point, x, y, choice.ties); });
    }
    case PrimitiveKind::line: {
      auto pixels =
          line_in_rows({p[0], p[1]}, primitive.state->line_width, all, target.height, choice);
      std::sort(pixels.begin(), pixels.end(), row_first);
      return pixels;
    }
    case PrimitiveKind::triangle:
      return collect(bounds_near({p.data(), count}, Fixed(), all),
                     [&](int x, int y) { return triangle_covers(p, x, y, choice.ties); });
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
