// SPDX-License-Identifier: MIT
#include "rules/coverage/polygon_facing.h"

namespace edgecase {
namespace {

int sign_of_area(const std::array<HomogeneousPoint, 3>& positions) {
  return sign(cross(positions[0], positions[1], positions[2]));
}

}  // namespace

// A primitive without area faces the back in either winding.
bool is_front_facing(const ScenePrimitive& primitive,
                     const std::array<HomogeneousPoint, 3>& positions, FacingMethod method) {
  if (primitive.kind != PrimitiveKind::triangle) return true;
  const bool is_clockwise_front =
      primitive.state->front_face == FrontFace::cw && method != FacingMethod::always_ccw;
  const int area = sign_of_area(positions) * (method == FacingMethod::reversed ? -1 : 1);
  return is_clockwise_front ? area < 0 : area > 0;
}

bool is_culled(const ScenePrimitive& primitive, const std::array<HomogeneousPoint, 3>& positions,
               FacingMethod method) {
  if (primitive.kind != PrimitiveKind::triangle || method == FacingMethod::not_culled) return false;
  switch (primitive.state->cull) {
    case CullMode::none:
      return false;
    case CullMode::front:
      return is_front_facing(primitive, positions, method);
    case CullMode::back:
      return !is_front_facing(primitive, positions, method);
    case CullMode::front_and_back:
      return true;
  }
  return false;
}

Rule polygon_facing_rule() {
  return {RuleId::polygon_facing,
          "A polygon faces the front if its winding in the window is the one that the draw sets",
          "14.6.1 (basic polygon rasterization)",
          "that of the vertices' positions (ruling 40)",
          "as-set",
          alternatives_of<FacingMethod>(),
          {{40,
            "Facing: by the sign of the area that the vertices have in the window, y up, in the "
            "order of assembly (14.6.1); a polygon of no area faces the back. Where some moves of "
            "the vertices that ruling 4 allows make the area positive and others make it negative "
            "or 0, the polygon may face either way: it may be culled or not, and the stencil state "
            "of either face may hold for it, the same for all of its fragments. Of a clipped "
            "polygon the area may be that before or after clipping: where the vertices that lie "
            "behind the eye give the former another sign, it may face either way."}}};
}

}  // namespace edgecase
