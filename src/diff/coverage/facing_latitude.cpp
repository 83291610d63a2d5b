// SPDX-License-Identifier: MIT
#include "diff/coverage/facing_latitude.h"

#include <cstddef>
#include <cstdlib>
#include <vector>

#include "diff/coverage/vertex_latitude.h"
#include "exact/fixed.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

struct Signs {
  bool may_be_positive = false;
  bool may_be_negative = false;
};

// The area is linear in each of the six components of the vertices' moves: over the open box of
// moves it takes a sign exactly if it has that sign at a corner of the box.
Signs signs_of_area(const Triangle& t, Fixed reach) {
  Signs signs;
  for (int corner = 0; corner < 64; ++corner) {
    const auto at = [&](Fixed coordinate, int bit) {
      return Int128{coordinate.raw()} + ((corner >> bit & 1) != 0 ? reach.raw() : -reach.raw());
    };
    const Int128 ax = at(t[0].x, 0);
    const Int128 ay = at(t[0].y, 1);
    const Int128 area =
        (at(t[1].x, 2) - ax) * (at(t[2].y, 5) - ay) - (at(t[1].y, 3) - ay) * (at(t[2].x, 4) - ax);
    signs.may_be_positive = signs.may_be_positive || area > 0;
    signs.may_be_negative = signs.may_be_negative || area < 0;
  }
  return signs;
}

// For a clipped triangle, by a bound: if each vertex moves by at most r in x and in y, twice the
// area changes by at most the sum of r (|dx| + |dy|) from each vertex' neighbour to its other one,
// and 2 r^2 for each pair of neighbours.
Signs signs_of_seen_area(const LoosePolygon& polygon) {
  const std::vector<Point>& p = polygon.vertices;
  if (p.size() < 3) return {true, true};
  const Int128 reach = polygon.reach.raw();
  Int128 area = 0;
  Int128 change = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point before = p[(i + p.size() - 1) % p.size()];
    const Point after = p[(i + 1) % p.size()];
    area += Int128{p[i].x.raw()} * after.y.raw() - Int128{after.x.raw()} * p[i].y.raw();
    change += reach * (std::abs(after.x.raw() - before.x.raw()) +
                       std::abs(after.y.raw() - before.y.raw())) +
              2 * reach * reach;
  }
  return {area + change > 0, area - change < 0};
}

// 14.6.1 also permits the area of the polygon before clipping. The quotients of a vertex behind the
// eye lie on its other side: with one or three such vertices, that area has the opposite sign. A
// vertex in the plane of the eye has no quotients, and so no sign.
bool may_turn_unclipped(const ScenePrimitive& triangle) {
  int behind = 0;
  for (const HomogeneousPoint& vertex : triangle.positions) {
    if (vertex.w == 0) return true;
    behind += vertex.w < 0 ? 1 : 0;
  }
  return behind % 2 == 1;
}

Signs signs_of(const ScenePrimitive& triangle, int bits) {
  if (triangle.is_clipped) {
    const Signs seen = signs_of_seen_area(loose_polygon(triangle, bits));
    if (!may_turn_unclipped(triangle)) return seen;
    return {true, true};
  }
  // Quotients are rounded to the nearest point; reach_of accounts for the error.
  return signs_of_area(nearest_triangle(triangle.positions), reach_of(triangle, bits));
}

}  // namespace

FacingLatitude permitted_facing(const ScenePrimitive& primitive, int bits) {
  if (primitive.kind != PrimitiveKind::triangle) return {};
  const Signs signs = signs_of(primitive, bits);
  if (primitive.state->front_face == FrontFace::ccw)
    return {signs.may_be_positive, signs.may_be_negative};
  return {signs.may_be_negative, signs.may_be_positive};
}

CullingLatitude permitted_culling(const ScenePrimitive& primitive, int bits) {
  const CullMode cull = primitive.state->cull;
  if (primitive.kind != PrimitiveKind::triangle || cull == CullMode::none) return {};
  const bool drops_front = cull == CullMode::front || cull == CullMode::front_and_back;
  const bool drops_back = cull == CullMode::back || cull == CullMode::front_and_back;
  const auto [front, back] = permitted_facing(primitive, bits);
  return {(front && drops_front) || (back && drops_back),
          (front && !drops_front) || (back && !drops_back)};
}

}  // namespace edgecase
