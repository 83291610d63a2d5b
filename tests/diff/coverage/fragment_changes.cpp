// SPDX-License-Identifier: MIT
#include "tests/diff/coverage/fragment_changes.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "tests/support/points.h"

namespace edgecase {

Fragments::iterator end_of(const Scene& scene, Fragments& fragments, int primitive, bool last) {
  const Point from =
      primitives_of(scene).at(static_cast<std::size_t>(primitive)).vertices[0]->position;
  const auto distance = [&](const Fragment& f) {
    constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
    if (f.primitive != primitive) return last ? -kFar : kFar;
    const Point centre = pixel_centre(f.x, f.y);
    return std::abs(centre.x.raw() - from.x.raw()) + std::abs(centre.y.raw() - from.y.raw());
  };
  const auto nearer = [&](const Fragment& a, const Fragment& b) {
    return distance(a) < distance(b);
  };
  return last ? std::max_element(fragments.begin(), fragments.end(), nearer)
              : std::min_element(fragments.begin(), fragments.end(), nearer);
}

Scene moved(Scene scene, double dx, double dy) {
  const Point by = at(dx, dy);
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices)
      vertex.position = {vertex.position.x + by.x, vertex.position.y + by.y};
  return scene;
}

}  // namespace edgecase
