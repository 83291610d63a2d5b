// SPDX-License-Identifier: MIT
//
// Ruling 40: which ways a triangle may face, where moves of its vertices within rulings 4 and 15
// can turn it round, or its area before clipping has another sign than that of what is seen.
#pragma once

#include "model/scene.h"

namespace edgecase {

// Never neither.
struct FacingLatitude {
  bool may_face_front = true;
  bool may_face_back = false;
};

// `bits` as in ruling 4. Points and lines face the front.
FacingLatitude permitted_facing(const ScenePrimitive& primitive, int bits);

// Of a primitive: may it be dropped, may it be drawn, as its draw culls?
struct CullingLatitude {
  bool may_be_culled = false;
  bool may_be_drawn = true;
};
CullingLatitude permitted_culling(const ScenePrimitive& primitive, int bits);

}  // namespace edgecase
