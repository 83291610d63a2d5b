// SPDX-License-Identifier: MIT
#include "tests/raster/operation_scenes.h"

#include <cmath>
#include <utility>
#include <vector>

#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

char digit(std::uint32_t value) {
  return value < 10 ? static_cast<char>('0' + value) : '+';
}

}  // namespace

Scene operation_scene(int size, DepthFormat depth, StencilFormat stencil) {
  Scene scene = blank_scene(size, size);
  scene.target.depth = depth;
  scene.target.stencil = stencil;
  return scene;
}

Draw rectangle(Viewport area, double depth, const Color& color) {
  const double right = area.x + area.width, top = area.y + area.height;
  const std::vector<Point> corners = {at(area.x, area.y), at(right, area.y), at(area.x, top),
                                      at(right, top)};
  Draw draw = make_draw(Primitive::triangle_strip, corners);
  for (Vertex& vertex : draw.vertices) {
    vertex.z = Fixed::from_raw(static_cast<std::int64_t>((2 * depth - 1) * Fixed::kOne));
    vertex.color = color;
  }
  draw.operations.depth.write = false;
  return draw;
}

Draw turned_round(Draw rectangle) {
  std::swap(rectangle.vertices.at(0), rectangle.vertices.at(1));
  std::swap(rectangle.vertices.at(2), rectangle.vertices.at(3));
  return rectangle;
}

std::string grid(const Rendering& rendering, const std::function<char(std::size_t)>& shown) {
  std::string rows;
  for (int y = rendering.height - 1; y >= 0; --y) {
    for (int x = 0; x < rendering.width; ++x) rows += shown(rendering.pixel_index(x, y));
    rows += '/';
  }
  return rows;
}

std::string colors(const Rendering& rendering) {
  return grid(rendering, [&](std::size_t pixel) {
    const auto begin = rendering.pixels.begin() + static_cast<std::ptrdiff_t>(4 * pixel);
    unsigned bits = 0;
    for (unsigned c = 0; c < 3; ++c) {
      if (begin[c] != 0 && begin[c] != 255) return '?';
      bits |= (begin[c] & 1u) << c;
    }
    return ".RGYBMCW"[bits];
  });
}

std::string stencils(const Rendering& rendering) {
  return grid(rendering, [&](std::size_t pixel) { return digit(rendering.stencils.at(pixel)); });
}

std::string hits(const Rendering& rendering) {
  return grid(rendering, [&](std::size_t pixel) { return digit(rendering.hits.at(pixel)); });
}

std::string depths(const Rendering& rendering) {
  return grid(rendering, [&](std::size_t pixel) {
    return digit(static_cast<std::uint32_t>(std::lround(8 * rendering.depths.at(pixel))));
  });
}

}  // namespace edgecase
