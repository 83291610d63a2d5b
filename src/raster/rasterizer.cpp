// SPDX-License-Identifier: MIT
#include "raster/rasterizer.h"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

#include "raster/attributes.h"
#include "raster/texture_stage.h"
#include "rules/coverage/homogeneous_line.h"
#include "rules/coverage/homogeneous_point.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

// Pixels whose centres can lie in a point's square, and some around it.
PixelBounds bounds_near(Point vertex, Fixed size, const PixelBounds& all) {
  const std::int64_t margin = size.ceil() / 2 + 1;
  const auto low = [&](int bound, Fixed at) {
    return static_cast<int>(std::max<std::int64_t>(bound, at.floor() - margin));
  };
  const auto high = [&](int bound, Fixed at) {
    return static_cast<int>(std::min<std::int64_t>(bound, at.floor() + margin));
  };
  return {low(all.x_min, vertex.x), low(all.y_min, vertex.y), high(all.x_max, vertex.x),
          high(all.y_max, vertex.y)};
}

bool row_first(PixelPosition a, PixelPosition b) {
  return std::tie(a.y, a.x) < std::tie(b.y, b.x);
}

void write_color(Rendering& rendering, std::size_t pixel, const std::array<double, 4>& color) {
  for (std::size_t i = 0; i < 4; ++i) rendering.pixels[4 * pixel + i] = to_unorm8(color[i]);
}

// Nothing drawn yet.
Rendering cleared(const Target& target) {
  Rendering rendering;
  rendering.width = target.width;
  rendering.height = target.height;
  rendering.samples = target.samples;
  const auto count =
      static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height);
  rendering.pixels.resize(4 * count);
  rendering.hits.resize(count);
  if (target.depth != DepthFormat::none) rendering.depths.assign(count, 1);
  std::array<double, 4> clear{};
  std::copy(target.clear.begin(), target.clear.end(), clear.begin());
  for (std::size_t pixel = 0; pixel < count; ++pixel) write_color(rendering, pixel, clear);
  return rendering;
}

// Each fragment overwrites what was there: drawing order is all that counts.
void write(Rendering& rendering, const Fragment& fragment, DepthFormat format) {
  const std::size_t pixel = rendering.pixel_index(fragment.x, fragment.y);
  write_color(rendering, pixel, fragment.color);
  if (format != DepthFormat::none) rendering.depths[pixel] = to_depth(fragment.depth, format);
  ++rendering.hits[pixel];
  rendering.fragments.push_back(fragment);
}

// What a primitive is made of, by where its vertices are: at multiples of 2^-16, or at quotients.
struct Dyadic {
  using Vertex = Point;
  using Sized = SizedPoint;
  using Line = Segment;
};
struct Quotient {
  using Vertex = HomogeneousPoint;
  using Sized = HomogeneousSizedPoint;
  using Line = HomogeneousSegment;
};

Point nearest(Point vertex) {
  return vertex;
}
Point nearest(const HomogeneousPoint& vertex) {
  return nearest_point(vertex);
}

template <class Sized>
std::vector<PixelPosition> point_pixels(const Sized& point, const PixelBounds& bounds,
                                        const TieRule& ties) {
  const PixelBounds near = bounds_near(nearest(point.vertex), point.size, bounds);
  std::vector<PixelPosition> pixels;
  for (int y = near.y_min; y <= near.y_max; ++y)
    for (int x = near.x_min; x <= near.x_max; ++x)
      if (point_covers(point, x, y, ties)) pixels.push_back({x, y});
  return pixels;
}

// The pixels of a primitive whose vertices are where the choice has them, in no particular order.
template <class Kind>
std::vector<PixelPosition> pixels_of(const ScenePrimitive& primitive,
                                     const std::array<typename Kind::Vertex, 3>& p,
                                     const PixelBounds& bounds, const CoverageChoice& choice) {
  const Draw& state = *primitive.state;
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_pixels(typename Kind::Sized{moved(p[0], choice.point_offset), state.point_size},
                          bounds, choice.ties);
    case PrimitiveKind::line:
      return line_pixels(typename Kind::Line{p[0], p[1]}, state.line_width, bounds, choice.line,
                         choice.ties);
    case PrimitiveKind::triangle:
      return triangle_pixels(p, bounds, choice.triangle_algorithm, choice.ties);
  }
  return {};
}

// The pixels of a primitive whose vertices are given; the choice snaps them. Quotients that it does
// not snap stay such.
std::vector<PixelPosition> pixels_of(const ScenePrimitive& primitive,
                                     const std::array<HomogeneousPoint, 3>& given,
                                     const PixelBounds& bounds, const CoverageChoice& choice) {
  if (choice.snap.is_none() && has_clip_positions(primitive))
    return pixels_of<Quotient>(primitive, given, bounds, choice);
  return pixels_of<Dyadic>(primitive,
                           {choice.snap(given[0]), choice.snap(given[1]), choice.snap(given[2])},
                           bounds, choice);
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
  auto p = primitive.positions;
  if (turned)
    for (HomogeneousPoint& point : p) point = turned_over(point, target.height);
  auto pixels = pixels_of(primitive, p, bounds, choice);
  if (turned)
    for (PixelPosition& pixel : pixels) pixel.y = target.height - 1 - pixel.y;
  std::sort(pixels.begin(), pixels.end(), row_first);
  return pixels;
}

Rendering rasterize(const Scene& scene, const Policy& policy) {
  const Target& target = scene.target;
  const RuleChoices choices = resolve(policy, target.surface);
  Rendering rendering = cleared(target);
  std::optional<TextureStage> textures;
  if (!scene.textures.empty()) rendering.mip_chains = textures.emplace(scene, choices).chains();
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const CoverageChoice& choice = choices.of(primitive.kind);
    const PrimitiveAttributes attributes = attributes_of(primitive, choices, target);
    std::optional<TexturedPrimitive> textured;
    if (primitive.state->texture) textured.emplace(textures.value(), primitive, attributes);
    for (PixelPosition pixel : covered_pixels(primitive, target, choice)) {
      std::optional<ExactLookup> lookup;
      if (textured) lookup = textured->look_up(pixel);
      const ExactLookup* shown = lookup ? &*lookup : nullptr;
      Fragment fragment = shade(primitive, attributes, pixel, shown);
      if (scene.details.any()) {
        fragment.detail = static_cast<int>(rendering.details.size());
        rendering.details.push_back(shade_details(attributes,
                                                  quad_of(pixel, choices.values, target),
                                                  choices.values, scene.details, shown));
      }
      write(rendering, fragment, target.depth);
    }
  }
  sort_fragments(rendering);
  return rendering;
}

}  // namespace edgecase
