// SPDX-License-Identifier: MIT
//
// One primitive for tests, with all that it points to.
#pragma once

#include <array>

#include "model/scene.h"

namespace edgecase {

struct Held {
  Draw draw;
  ScenePrimitive primitive;
  std::array<Vertex, 3> vertices;

  Held(PrimitiveKind kind, std::array<Point, 3> points, Fixed size, AttributeLocation location) {
    draw.line_width = draw.point_size = size;
    draw.multisampling.location = location;
    primitive.kind = kind;
    primitive.state = &draw;
    for (std::size_t i = 0; i < 3; ++i) {
      vertices[i].position = points[i];
      primitive.vertices[i] = &vertices[i];
      primitive.positions[i] = homogeneous(points[i]);
    }
  }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
};

}  // namespace edgecase
