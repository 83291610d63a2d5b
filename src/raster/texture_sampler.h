// SPDX-License-Identifier: MIT
//
// The exact rasterizer's texture sampler: a colour out of a texture, at a point, for a level of
// detail.
//
// Everything comes as intervals, and all colours that any values within them yield go out. So one
// function answers what is exact (the intervals are a few units of double precision wide, and the
// answer is one colour) and what the specification permits (they are as wide as its latitude).
// Anisotropic filters are not here: they are several of these lookups.
#pragma once

#include <vector>

#include "exact/interval.h"
#include "model/texture.h"
#include "rules/textures/texture_choice.h"
#include "rules/textures/texture_image.h"

namespace edgecase {

// A point and a level of detail to look up. Numbers that are not finite have a defined answer, here
// as there is none in OpenGL: coordinates as texel_filter.h says, and a lambda of NaN is 0. An end
// that is not a number knows nothing on its side.
struct TextureSample {
  TexturePoint point;
  Interval lambda;  // clamped, see rules/textures/level_of_detail.h
};

// Where filtered texels that are still sRGB's are decoded (8.24).
enum class SrgbDecoding {
  of_texels,  // before they come here
  of_levels,  // what each level yields, before two levels are mixed
  at_last,
};

// How much farther than the choice goes what is looked up may lie: nothing, for exact colours.
struct SampleLatitude {
  double texel = 0;      // texels that a coordinate may be off
  double weight = 0;     // by which the weight of the second level may be off
  bool any_tie = false;  // both levels at a tie
  SrgbDecoding decoding = SrgbDecoding::of_texels;
};

// The last level that is used, as last_level, and one that the chain has: a chain that ends early,
// as a policy may have it, is used up to its end.
int last_level_of(const DecodedTexture& decoded, const Sampler& sampler, const Texture& texture);

// All boxes in which the colour may be, none twice; one of an exact sample. Where both of two
// levels may yield many colours (more than 1,000 pairs), one box holds those of the second.
std::vector<Texel> sample(const DecodedTexture& decoded, const Texture& texture,
                          const Sampler& sampler, const TextureChoice& choice,
                          const TextureSample& at, const SampleLatitude& latitude = {});

// (1 - weight) a + weight b, of a weight of 0 to 1. Where both are the same, so is what comes out.
Texel mixed(const Texel& a, const Texel& b, Interval weight);
bool same_box(const Texel& a, const Texel& b);
// The smallest box that holds all, of which there is one at least.
Texel hull_of(const std::vector<Texel>& boxes);

}  // namespace edgecase
