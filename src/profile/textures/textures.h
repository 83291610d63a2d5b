// SPDX-License-Identifier: MIT
//
// Textures: which alternatives of the rules for lookups, levels of detail and mip chains a renderer
// follows, and how far its levels of detail are from the formulas' levels.
//
//   probes -> filters and their weights -> ramps -> level of detail -> ties of levels, biases,
//   anisotropy, mip chains -> more ramps -> residuals
//
// Renderings are dropped as they are counted.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/interval.h"
#include "exact/pixel.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "profile/textures/texture_scenes.h"
#include "raster/attributes.h"
#include "rules/choices.h"

namespace edgecase {

inline constexpr std::array kTextureFormats{TextureFormat::rgba8, TextureFormat::srgb8,
                                            TextureFormat::rgba32f};

// How traits name a format; empty of rgba8, which speaks for the rule itself.
inline std::string probe_of(TextureFormat format) {
  return format == TextureFormat::rgba8 ? "" : name_of(format);
}

// ---------------------------------------------------------------------------------------- lookups

// The lookup of one fragment, as the renderer reports it.
struct FragmentLookup {
  PixelPosition pixel;
  int primitive = 0;
  std::array<double, 4> color{};
  std::optional<std::array<double, 2>> coordinates;  // s and t
  std::optional<double> lambda_prime;                // textureQueryLod's y
};

struct LookupScene {
  Scene scene;
  std::vector<FragmentLookup> lookups;
};

// Some of a rendering's fragments with colours, evenly spread over their list: `most` at most.
std::vector<FragmentLookup> lookups_of(const Rendering& rendering, std::size_t most);

// The trait of a rule that colours decide. An alternative yields a lookup where its colour, at the
// coordinates that the renderer reports, is the renderer's, but for float32 rounding; or for codes
// of 8 bits, where all colours are codes. Lookups that all alternatives yield, or none, are no
// evidence. `found`: what is known so far, of textures and all else.
Trait infer_texture_rule(const TraitId& id, std::span<const LookupScene> scenes,
                         const RuleChoices& found);

// ------------------------------------------------------------------------------- levels of detail

// The levels of detail of one ramp by formula: a draw, one texture.
class RampLevels {
 public:
  // `scene` must outlive it.
  RampLevels(const Scene& scene, const RuleChoices& found);

  // The footprint of a pixel, its derivatives exactly so, or as float32 may have them.
  Footprint exact_footprint(const FragmentLookup& lookup, DerivativeMethod method) const;
  Footprint rounded_footprint(const FragmentLookup& lookup, DerivativeMethod method) const;

  // The level that the renderer reports; none where it reports none.
  std::optional<double> reported(const FragmentLookup& lookup, LevelSource source) const;
  // What may be reported of a lambda_base.
  Interval reportable(Interval lambda_base, LevelSource source) const;
  // Are both the same end of the levels that there are, so that neither says how far beyond it is?
  bool are_ends(double a, double b, LevelSource source) const;

 private:
  template <class Derivative>
  Footprint footprint_by(const Derivative& derivative) const;

  const Scene& scene_;
  const RuleChoices& found_;
  std::vector<PrimitiveAttributes> attributes_;
  double last_ = 0;
};

// texture.scale-factor, texture.log2 and texture.derivatives, which only together make a level of
// detail: of all combinations the one that yields most of the lambda' that textureQueryLod returns
// and of the levels that ramps look up.
std::vector<Trait> infer_level_of_detail(std::span<const LookupScene> ramps,
                                         const RuleChoices& found);

// Counts how far the levels of detail of one surface are from what formulas make of the exact
// texture coordinates: the formula that the renderer is found to follow, and beside it all others
// that are catalogued, a scale factor and a logarithm each. Derivatives are the exact coordinates',
// by the method that the renderer is found to follow.
class ResidualTable {
 public:
  explicit ResidualTable(const RuleChoices& found) : found_(found) {}

  void add(RampKind kind, const std::string& id, const Scene& scene,
           const std::vector<FragmentLookup>& lookups);
  // In the order in which kinds were added; none of a source that nothing was reported of.
  std::vector<LevelResiduals>& rows() { return rows_; }

 private:
  LevelResiduals& row(RampKind kind, LevelSource source);

  RuleChoices found_;
  std::vector<LevelResiduals> rows_;
};

// ------------------------------------------------------------------------------------- mip chains

// A whole chain that the renderer generated of one image.
struct GeneratedChain {
  TextureFormat format = TextureFormat::rgba8;
  std::vector<TextureLevel> levels;
};

// mipmap.filter, mipmap.rounding and mipmap.srgb: each level against the renderer's own before it.
// Those of rgba8, and mipmap.srgb of srgb8, hold for all; traits with a format's name hold for that
// format alone.
std::vector<Trait> infer_mip_chains(std::span<const GeneratedChain> chains);

extern const Subject kTextureSubject;

}  // namespace edgecase
