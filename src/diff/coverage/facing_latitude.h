// SPDX-License-Identifier: MIT
//
// Ruling 40: which ways a triangle may face, if moves of its vertices within rulings 4 and 15 can
// turn it round, or if its area before clipping has another sign than that of its visible part.
#pragma once

#include "model/scene.h"

namespace edgecase {

// At least one of the two is true.
struct FacingLatitude {
  bool may_face_front = true;
  bool may_face_back = false;
};

// `bits` as in ruling 4. Points and lines face the front.
FacingLatitude permitted_facing(const ScenePrimitive& primitive, int bits);

// For a primitive: may it be dropped, may it be drawn, given its draw's culling?
struct CullingLatitude {
  bool may_be_culled = false;
  bool may_be_drawn = true;
};
CullingLatitude permitted_culling(const ScenePrimitive& primitive, int bits);

}  // namespace edgecase
