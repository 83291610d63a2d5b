// SPDX-License-Identifier: MIT
#include "casefile/scene/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace edgecase {

namespace {

// Whole pixels from `left` to `right` and from `bottom` to `top`; the latter are excluded.
struct Box {
  std::int64_t left = 0;
  std::int64_t bottom = 0;
  std::int64_t right = 0;
  std::int64_t top = 0;

  std::int64_t width() const { return std::max<std::int64_t>(right - left, 0); }
  std::int64_t height() const { return std::max<std::int64_t>(top - bottom, 0); }
  std::int64_t area() const { return width() * height(); }
};

Box common(const Box& a, const Box& b) {
  return {std::max(a.left, b.left), std::max(a.bottom, b.bottom), std::min(a.right, b.right),
          std::min(a.top, b.top)};
}

Box drawable(const Draw& draw, const Target& target) {
  const Box whole{0, 0, target.width, target.height};
  if (!draw.scissor) return whole;
  const Viewport& s = *draw.scissor;
  return common(whole, {s.x, s.y, std::int64_t{s.x} + s.width, std::int64_t{s.y} + s.height});
}

// A box with all pixels that a primitive touches: that of its vertices, grown by `thickness` on
// each side, in whole pixels.
Box box_of(const ScenePrimitive& primitive, std::int64_t thickness) {
  const auto count = static_cast<std::size_t>(vertices_of(primitive.kind));
  Point low = primitive.vertices[0]->position;
  Point high = low;
  for (std::size_t i = 1; i < count; ++i) {
    const Point at = primitive.vertices[i]->position;
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  return {low.x.floor() - thickness, low.y.floor() - thickness, high.x.floor() + 1 + thickness,
          high.y.floor() + 1 + thickness};
}

// The pixels between a primitive's corners, inclusive, if each corner lies before the eye. Corners
// far beyond the window are moved closer, where still no target reaches.
std::optional<Box> box_of_corners(const ScenePrimitive& primitive) {
  constexpr std::int64_t kFar = std::int64_t{1} << 16;
  Box box{kFar, kFar, -kFar, -kFar};
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(primitive.kind)); ++i) {
    const HomogeneousPoint& at = primitive.positions[i];
    if (at.w <= 0) return std::nullopt;
    const auto column = [&](std::int64_t numerator) {
      const std::int64_t whole = numerator / at.w - (numerator % at.w < 0 ? 1 : 0);
      return std::clamp(whole, -kFar, kFar);
    };
    box = {std::min(box.left, column(at.x)), std::min(box.bottom, column(at.y)),
           std::max(box.right, column(at.x) + 1), std::max(box.top, column(at.y) + 1)};
  }
  return box;
}

// An upper bound of a length, in whole pixels.
std::int64_t whole_pixels(Fixed length) {
  return length.floor() + 1;
}

Fixed half(Fixed length) {
  return Fixed::from_raw(length.raw() / 2);
}

std::int64_t most_pixels(const ScenePrimitive& primitive, const Box& drawable) {
  if (primitive.is_clipped && primitive.kind == PrimitiveKind::triangle)
    return common(box_of_corners(primitive).value_or(drawable), drawable).area();
  if (primitive.is_clipped || primitive.is_cut) return drawable.area();
  const Draw& draw = *primitive.state;
  if (primitive.kind == PrimitiveKind::point)
    return common(box_of(primitive, whole_pixels(half(draw.point_size))), drawable).area();
  if (primitive.kind == PrimitiveKind::line) {
    // Per column (per row if steep) a line rises by at most one pixel, and its height is less than
    // 1.5 times its width.
    const Box box = common(box_of(primitive, whole_pixels(half(draw.line_width))), drawable);
    const std::int64_t across = 2 * whole_pixels(draw.line_width) + 2;
    return std::min(box.area(), std::max(box.width(), box.height()) * across);
  }
  // A triangle is at most half its box, and its border touches at most twice as many pixels as the
  // box's border.
  const Box box = box_of(primitive, 0);
  const std::int64_t inside = box.area() / 2 + 2 * (box.width() + box.height()) + 4;
  return std::min(inside, common(box, drawable).area());
}

}  // namespace

std::uint64_t most_drawn_samples(const Scene& scene) {
  std::uint64_t pixels = 0;
  for (const ScenePrimitive& primitive : primitives_of(scene))
    pixels += static_cast<std::uint64_t>(
        most_pixels(primitive, drawable(*primitive.state, scene.target)));
  const std::size_t passes = std::max<std::size_t>(scene.supersampling.size(), 1);
  return pixels * static_cast<std::uint64_t>(scene.target.samples) * passes;
}

void check_draw_work(const Scene& scene, const Place& draws, Findings& findings) {
  const std::uint64_t samples = most_drawn_samples(scene);
  if (samples > kMaxDrawnSamples)
    findings.add(draws, fmt::format("the primitives may cover {} samples", samples),
                 fmt::format("draw less, or to a smaller target: {} samples at most, each counted "
                             "as often as it is covered",
                             kMaxDrawnSamples));
}

}  // namespace edgecase
