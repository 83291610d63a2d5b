// SPDX-License-Identifier: MIT
//
// The exact rasterizer's textures: the sampler, and the stage that uses it.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "exact/fixed.h"
#include "exact/interval.h"
#include "model/scene.h"
#include "model/texture.h"
#include "raster/attributes.h"
#include "rules/choices.h"
#include "rules/textures/texture_image.h"
#include "rules/values/coordinate_pairs.h"

namespace edgecase {

// The texture sampler: the colour of a texture at a point, for a level of detail.
//
// Inputs are intervals, and the results hold all colours that any values within them yield. So one
// function computes both the exact colour (inputs a few units of double precision wide, one result)
// and the permitted colours (inputs as wide as the specification's latitude). Anisotropic filters
// are composed of several such lookups elsewhere.

// A point and a level of detail to look up. OpenGL leaves results of numbers that are not finite
// undefined; here coordinates behave as in texel_filter.h, and a lambda of NaN counts as 0. An end
// that is NaN leaves its side unbounded.
struct TextureSample {
  TexturePoint point;
  Interval lambda;  // clamped, see rules/textures/level_of_detail.h
};

// The point at which sRGB texels are decoded (8.24).
enum class SrgbDecoding {
  of_texels,  // before filtering
  of_levels,  // each level's result, before two levels are mixed
  at_last,
};

// Additional latitude of a lookup beyond the choice; none for exact colours.
struct SampleLatitude {
  double texel = 0;      // error of a coordinate, in texels
  double weight = 0;     // error of the second level's weight
  bool any_tie = false;  // both levels are permitted at a tie
  SrgbDecoding decoding = SrgbDecoding::of_texels;
};

// The last level used, as last_level, but within the chain: a chain that ends early under a policy
// is used up to its end.
int last_level_of(const DecodedTexture& decoded, const Sampler& sampler, const Texture& texture);

// All boxes that may hold the colour, without duplicates; one for an exact sample. If two levels
// yield more than 1,000 pairs of colours, one box stands for the second level's.
Texels sample(const DecodedTexture& decoded, const Texture& texture, const Sampler& sampler,
              const TextureChoice& choice, const TextureSample& at,
              const SampleLatitude& latitude = {});

// (1 - weight) a + weight b, for a weight of 0 to 1. Equal operands give exactly that value.
Texel mixed(const Texel& a, const Texel& b, Interval weight);
bool same_box(const Texel& a, const Texel& b);
// The smallest box that holds all of `boxes`, at least one.
Texel hull_of(std::span<const Texel> boxes);
inline Texel hull_of(const Texels& boxes) {
  return hull_of(std::span(boxes.data(), boxes.size()));
}

// The texture stage: what the fragments of textured draws look up, under a policy.
//
// Which texel holds a point and which level a scale factor selects are yes-or-no questions. If an
// interval leaves one open, the number is computed again as a rational: coordinates are quotients
// of integers, a squared scale factor is one too, and log2(rho) is a multiple of 1/2 exactly where
// rho squared is a power of two.

// The result of textureQueryLod: x is ExactLookup::accessed, y is ExactLookup::lambda_prime, for a
// lookup without a bias, level or gradients from the shader.
using QueriedLevel = std::array<Interval, 2>;

// The exact lookup of a fragment.
struct ExactLookup {
  std::array<Interval, 2> coordinates;  // s and t, as interpolated
  // The point of the lookup under the filter that lambda selects: equivalent to `coordinates` under
  // the wrap modes, and on one side of each border of the filter. If a number on a border is no
  // double, this is the next double on the side where it belongs.
  TexturePoint point;
  // In texels of the base level per pixel; zeros if the shader gives the level itself.
  Footprint footprint;
  Interval lambda_prime;  // before clamping
  Interval lambda;
  Interval accessed;
  QueriedLevel queried;
  Texel color;  // a few units of double precision wide
};

// For one thread.
class TextureStage {
 public:
  // `scene` and `choices` must outlive the stage. Generated chains are those of the policy.
  TextureStage(const Scene& scene, const RuleChoices& choices);

  // Replaces generated chains by a renderer's own, keyed by the number of their texture.
  void take_chains(const std::map<std::size_t, std::vector<TextureLevel>>& chains);

  // The lookup of a textured draw at a pixel, whose centre may lie outside the primitive.
  // TexturedPrimitive is faster for many pixels of one primitive.
  ExactLookup look_up(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
                      PixelPosition pixel) const;

  const Scene& scene() const { return scene_; }
  const RuleChoices& choices() const { return choices_; }
  const DecodedTexture& decoded(std::size_t texture) const { return decoded_[texture]; }
  // The chains in use, for textures with generated levels.
  const std::map<std::size_t, std::vector<TextureLevel>>& chains() const { return chains_; }

  // The texture coordinates of its primitives, each of which takes a number.
  ExactCoordinates& coordinates() const { return coordinates_; }
  int next_number() const { return number_++; }

 private:
  const Scene& scene_;
  const RuleChoices& choices_;
  mutable ExactCoordinates coordinates_;
  mutable int number_ = 0;
  std::vector<DecodedTexture> decoded_;
  std::map<std::size_t, std::vector<TextureLevel>> chains_;
};

// The lookups of one primitive of a textured draw. Work that its pixels share is done once, so all
// arguments must outlive this object unchanged.
class TexturedPrimitive {
 public:
  TexturedPrimitive(const TextureStage& stage, const ScenePrimitive& primitive,
                    const PrimitiveAttributes& attributes);
  TexturedPrimitive(TexturedPrimitive&&) noexcept;
  TexturedPrimitive& operator=(TexturedPrimitive&&) noexcept;
  ~TexturedPrimitive();

  ExactLookup look_up(PixelPosition pixel);
  QueriedLevel queried(PixelPosition pixel);  // only this part of look_up

 private:
  class Lookups;
  std::unique_ptr<Lookups> lookups_;
};

}  // namespace edgecase
