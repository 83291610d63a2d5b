// SPDX-License-Identifier: MIT
//
// Texture traits: which alternatives of the rules for textures a renderer follows.
//
// An alternative yields a lookup where what it makes of it, at the coordinates that the renderer
// tells, is what the renderer tells, but for float32 rounding; or for codes of 8 bits, where all
// that is told are codes. Lookups that all alternatives yield, or none, say nothing.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "profile/profile.h"
#include "profile/textures/texture_evidence.h"
#include "profile/textures/texture_scenes.h"
#include "rules/choices.h"

namespace edgecase {

// The rules that hang on colours.
enum class TextureRule {
  level_weight,
  texel_grid,
  wrap,
  nearest_level,
  crossover,
  bias,
  anisotropy,
};

// `found`: what is known so far, of textures and all else.
Trait infer_texture_rule(TextureRule rule, std::string id, std::span<const ToldScene> scenes,
                         const RuleChoices& found);

// Takes over what a trait says, where it was learnt; what a rule's id does not name is left.
void adopt(const Trait& trait, TextureChoice& choice);

// texture.scale-factor, texture.log2 and texture.derivatives, which only together make a level of
// detail: those of all combinations that yield most of the lambda' that textureQueryLod tells and
// of the levels that ramps look up.
std::vector<Trait> infer_level_of_detail(std::span<const ToldScene> ramps,
                                         const RuleChoices& found);

// What a renderer made of one image, whole chains.
struct ToldChain {
  TextureFormat format = TextureFormat::rgba8;
  std::vector<TextureLevel> levels;
};

// mipmap.filter, mipmap.rounding and mipmap.srgb: each level against the renderer's own before it.
// Those of rgba8, and mipmap.srgb of srgb8, hold for all; traits with a format's name tell what is
// found for that format alone.
std::vector<Trait> infer_mip_chains(std::span<const ToldChain> chains);

}  // namespace edgecase
