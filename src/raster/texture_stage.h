// SPDX-License-Identifier: MIT
//
// The exact rasterizer's textures: the sampler, and the stage that asks it.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "exact/interval.h"
#include "exact/pixel.h"
#include "model/scene.h"
#include "model/texture.h"
#include "raster/attributes.h"
#include "rules/choices.h"
#include "rules/textures/texture_image.h"

namespace edgecase {

// The exact rasterizer's texture sampler: a colour out of a texture, at a point, for a level of
// detail.
//
// Everything comes as intervals, and all colours that any values within them yield go out. So one
// function answers what is exact (the intervals are a few units of double precision wide, and the
// answer is one colour) and what the specification permits (they are as wide as its latitude).
// Anisotropic filters are not here: they are several of these lookups.

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

// (1 - weight) a + weight b, of a weight of 0 to 1. Equal operands give that same value.
Texel mixed(const Texel& a, const Texel& b, Interval weight);
bool same_box(const Texel& a, const Texel& b);
// The smallest box that holds all of them; there must be at least one.
Texel hull_of(const std::vector<Texel>& boxes);

// The exact rasterizer's texture stage: what the fragments of textured draws look up, under a
// policy.
//
// Which texel holds a point and which level a scale factor selects are yes-or-no questions. Where
// an interval leaves one open, the number is computed again as a rational: coordinates are
// quotients of integers, a squared scale factor is one too, and log2(rho) is a multiple of 1/2
// exactly where rho squared is a power of two.

// What textureQueryLod tells: x as ExactLookup::accessed, y as ExactLookup::lambda_prime, of a
// lookup without a bias, a level or gradients by the shader.
using QueriedLevel = std::array<Interval, 2>;

// A fragment's lookup, exactly.
struct ExactLookup {
  std::array<Interval, 2> coordinates;  // s and t, as interpolated
  // Where they are looked up under the filter that lambda selects: equivalent under the wrap modes,
  // and on one side of each border that the filter asks for. A number on one that is no double is
  // the double next to it on the side that it belongs to.
  TexturePoint point;
  // In texels of the base level per pixel; zeros where the shader gives the level itself.
  Footprint footprint;
  Interval lambda_prime;  // before clamping
  Interval lambda;
  Interval accessed;
  QueriedLevel queried;
  Texel color;  // a few units of double precision wide
};

class TextureStage {
 public:
  // `scene` and `choices` must outlive the stage. Generated chains are the policy's.
  TextureStage(const Scene& scene, const RuleChoices& choices);

  // The same with what a renderer made of generated chains, by the number of their textures.
  void take_chains(const std::map<std::size_t, std::vector<TextureLevel>>& chains);

  // Of a textured draw. The pixel's centre may lie outside the primitive. Of many pixels of one
  // primitive, TexturedPrimitive looks up faster.
  ExactLookup look_up(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
                      PixelPosition pixel) const;

  const Scene& scene() const { return scene_; }
  const RuleChoices& choices() const { return choices_; }
  const DecodedTexture& decoded(std::size_t texture) const { return decoded_[texture]; }
  // The chains in force, of textures whose levels are generated.
  const std::map<std::size_t, std::vector<TextureLevel>>& chains() const { return chains_; }

 private:
  const Scene& scene_;
  const RuleChoices& choices_;
  std::vector<DecodedTexture> decoded_;
  std::map<std::size_t, std::vector<TextureLevel>> chains_;
};

// The lookups of one primitive of a textured draw. What its pixels share is computed once: all
// given must outlive it, and stay as it is.
class TexturedPrimitive {
 public:
  TexturedPrimitive(const TextureStage& stage, const ScenePrimitive& primitive,
                    const PrimitiveAttributes& attributes);
  TexturedPrimitive(TexturedPrimitive&&) noexcept;
  TexturedPrimitive& operator=(TexturedPrimitive&&) noexcept;
  ~TexturedPrimitive();

  ExactLookup look_up(PixelPosition pixel);
  QueriedLevel queried(PixelPosition pixel);  // as look_up tells it, and no more

 private:
  class Lookups;
  std::unique_ptr<Lookups> lookups_;
};

}  // namespace edgecase
