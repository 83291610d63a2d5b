// SPDX-License-Identifier: MIT
//
// Scenes for the tests of src/wire.
#pragma once

#include "model/scene.h"

namespace edgecase {

// A 3x2 target with one triangle and one line: primitives 0 and 1.
inline Scene small_scene() {
  Scene scene;
  scene.target.width = 3;
  scene.target.height = 2;
  scene.target.clear = {0, 0.25f, 0.1f, 1};
  scene.viewport = {-1, -2, 8, 16};
  const auto vertex = [](std::int64_t raw_x, std::int64_t raw_y, Color color) {
    Vertex result;
    result.position = {Fixed::from_raw(raw_x), Fixed::from_raw(raw_y)};
    result.z = Fixed::from_raw(raw_x / 7);
    result.color = color;
    return result;
  };
  Draw triangle;
  triangle.interpolation = Interpolation::smooth;
  triangle.provoking_vertex = ProvokingVertex::first;
  triangle.vertices = {vertex(1, -1, {1, 0, 0, 1}), vertex(200001, 65535, {0, 0.3f, 0, 1}),
                       vertex(0, 131072, {0, 0, 1e-7f, 0.5f})};
  Draw line;
  line.primitive = Primitive::lines;
  line.line_width = Fixed::from_raw(5 * Fixed::kOne / 2);
  line.point_size = Fixed::from_raw(1);
  line.scissor = Viewport{-1, 0, 3, 0};
  line.vertices = {vertex(-32768, 32768, {1, 1, 1, 1}), vertex(163840, 98304, {1, 1, 1, 1})};
  scene.draws = {triangle, line};
  return scene;
}

}  // namespace edgecase
