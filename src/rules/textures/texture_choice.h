// SPDX-License-Identifier: MIT
//
// What a policy says of texture lookups.
#pragma once

#include "rules/textures/anisotropy.h"
#include "rules/textures/level_of_detail.h"
#include "rules/textures/level_selection.h"
#include "rules/textures/mip_chain.h"
#include "rules/textures/texel_filter.h"
#include "rules/textures/wrap.h"
#include "rules/values/derivative.h"

namespace edgecase {

struct TextureChoice {
  WrapChoice wrap = WrapChoice::as_set;
  TexelGrid texel_grid = TexelGrid::none;
  ScaleFactor scale_factor = ScaleFactor::lengths;
  Log2Method log2 = Log2Method::exact;
  DerivativeMethod derivatives = DerivativeMethod::fine;  // that the scale factor is made of
  BiasChoice bias = BiasChoice::as_set;
  Crossover crossover = Crossover::zero;
  NearestLevel nearest_level = NearestLevel::down_at_ties;
  LevelWeight level_weight = LevelWeight::exact;
  Anisotropy anisotropy = Anisotropy::extension;
  LevelCount level_count = LevelCount::larger_side;
  MipmapMethod mipmap;  // of generated chains

  friend bool operator==(const TextureChoice&, const TextureChoice&) = default;
};

}  // namespace edgecase
