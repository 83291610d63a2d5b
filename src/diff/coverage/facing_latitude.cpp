// SPDX-License-Identifier: MIT
#include "diff/coverage/facing_latitude.h"

#include <array>

#include "diff/values/vertex_latitude.h"
#include "exact/wide.h"
#include "rules/coverage/homogeneous_triangle.h"

namespace edgecase {
namespace {

struct Signs {
  bool may_be_positive = false;
  bool may_be_negative = false;
};

// The area is linear in each of the six components of the vertices' moves: over the open box of
// moves it takes a sign exactly where a corner of the box has it.
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

}  // namespace

FacingLatitude permitted_facing(const ScenePrimitive& primitive, const Viewport& viewport,
                                int bits) {
  if (primitive.kind != PrimitiveKind::triangle) return {};
  // Of quotients, the nearest: reach_of knows how far off they are.
  const Signs signs =
      signs_of_area(nearest_triangle(primitive.positions), reach_of(primitive, viewport, bits));
  if (primitive.state->front_face == FrontFace::ccw)
    return {signs.may_be_positive, signs.may_be_negative};
  return {signs.may_be_negative, signs.may_be_positive};
}

CullingLatitude permitted_culling(const ScenePrimitive& primitive, const Viewport& viewport,
                                  int bits) {
  const CullMode cull = primitive.state->cull;
  if (primitive.kind != PrimitiveKind::triangle || cull == CullMode::none) return {};
  const bool drops_front = cull == CullMode::front || cull == CullMode::front_and_back;
  const bool drops_back = cull == CullMode::back || cull == CullMode::front_and_back;
  const auto [front, back] = permitted_facing(primitive, viewport, bits);
  return {(front && drops_front) || (back && drops_back),
          (front && !drops_front) || (back && !drops_back)};
}

}  // namespace edgecase
