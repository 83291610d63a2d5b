// SPDX-License-Identifier: MIT
//
// The exact rasterizer's texture stage: what the fragments of textured draws look up, under a
// policy.
//
// Which texel holds a point and which level a scale factor selects are yes-or-no questions. Where
// an interval leaves one open, the number is computed again as a rational: coordinates are
// quotients of integers, a squared scale factor is one too, and log2(rho) is a multiple of 1/2
// exactly where rho squared is a power of two.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "exact/pixel.h"
#include "model/scene.h"
#include "raster/attributes.h"
#include "raster/texture_sampler.h"
#include "rules/choices.h"

namespace edgecase {

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
