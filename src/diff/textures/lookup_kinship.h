// SPDX-License-Identifier: MIT
//
// Which choices about textures a lookup can show: without mirroring, none about mirroring.
#pragma once

#include "model/texture.h"
#include "rules/choices.h"

namespace edgecase {

// A kind of lookups: those of one draw, in primitives with perspective or without.
struct LookupKinship {
  const TextureUse* use = nullptr;
  const Texture* texture = nullptr;
  bool has_perspective = false;  // derivatives differ from pixel to pixel
  bool is_query = false;         // by textureQueryLod, which shows no texel
  bool is_level_given = false;   // lambda' is as the renderer reports it, whatever its origin
};

// True if the level of detail shows in the lookup.
bool shows_level(const LookupKinship& kin);

// The choice with OpenGL's own in place of everything that such a lookup cannot show: two choices
// that become equal yield the same.
TextureChoice relevant_part(const TextureChoice& choice, const LookupKinship& kin);

}  // namespace edgecase
