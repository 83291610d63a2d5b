// SPDX-License-Identifier: MIT
//
// Which choices about textures a lookup can show: without a mirrored image none about mirroring.
#pragma once

#include "model/texture.h"
#include "rules/textures/texture_choice.h"

namespace edgecase {

// A kind of lookups: of one draw, in primitives with perspective or without.
struct LookupKinship {
  const TextureUse* use = nullptr;
  const Texture* texture = nullptr;
  bool has_perspective = false;  // are derivatives other from pixel to pixel?
  bool is_query = false;         // of textureQueryLod, which shows no texel
  bool is_level_given = false;   // lambda' is what the renderer tells, whatever it made it of
};

// Does the level of detail show in the lookup?
bool shows_level(const LookupKinship& kin);

// The choice with OpenGL's own in the place of all that such a lookup cannot show: two choices of
// which this makes the same yield the same.
TextureChoice relevant_part(const TextureChoice& choice, const LookupKinship& kin);

}  // namespace edgecase
