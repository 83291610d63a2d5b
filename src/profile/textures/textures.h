// SPDX-License-Identifier: MIT
//
// Textures: which alternatives of the rules for lookups, levels of detail and mip chains a renderer
// follows, and how far its levels of detail are from the formulas.
//
//   probes -> filters and their weights -> ramps -> level of detail -> ties of levels, biases,
//   anisotropy, mip chains -> more ramps -> residuals
//
// Renderings are discarded once counted.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "exact/interval.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "profile/textures/texture_scenes.h"
#include "raster/attributes.h"
#include "rules/choices.h"

namespace edgecase {

inline constexpr std::array kTextureFormats{TextureFormat::rgba8, TextureFormat::srgb8,
                                            TextureFormat::rgba32f};

// The name of a format in traits; empty for rgba8, which stands for the rule itself.
inline std::string probe_of(TextureFormat format) {
  return format == TextureFormat::rgba8 ? "" : name_of(format);
}

// ---------------------------------------------------------------------------------------- lookups

// The lookup of one fragment, as reported by the renderer.
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

// At most `most` of a rendering's fragments with colours, evenly spread over their list.
std::vector<FragmentLookup> lookups_of(const Rendering& rendering, std::size_t most);

// The trait of a rule that colours decide. An alternative yields a lookup if its colour, at the
// reported coordinates, equals the renderer's up to float32 rounding, or up to rounding to 8-bit
// codes if all colours are codes. Lookups that all alternatives yield, or none, are no evidence.
// `found`: what is known so far, of textures and everything else.
Trait infer_texture_rule(const TraitId& id, std::span<const LookupScene> scenes,
                         const RuleChoices& found);

// ------------------------------------------------------------------------------- levels of detail

// The levels of detail of one ramp by formula, for one draw with one texture.
class RampLevels {
 public:
  // `scene` must outlive this object.
  RampLevels(const Scene& scene, const RuleChoices& found);

  // The footprint of a pixel, with exact derivatives, or with the errors of float32.
  Footprint exact_footprint(const FragmentLookup& lookup, DerivativeMethod method) const;
  Footprint rounded_footprint(const FragmentLookup& lookup, DerivativeMethod method) const;

  // The level that the renderer reports; nothing if it reports none.
  std::optional<double> reported(const FragmentLookup& lookup, LevelSource source) const;
  // The levels that may be reported for a lambda_base.
  Interval reportable(Interval lambda_base, LevelSource source) const;
  // Whether both are the same end of the existing levels, and so do not show how far they are.
  bool are_ends(double a, double b, LevelSource source) const;

 private:
  template <class Derivative>
  Footprint footprint_by(const Derivative& derivative) const;

  const Scene& scene_;
  const RuleChoices& found_;
  std::vector<PrimitiveAttributes> attributes_;
  double last_ = 0;
};

// texture.scale-factor, texture.log2 and texture.derivatives, which determine a level of detail
// only together: the combination that yields most of the lambda' of textureQueryLod and of the
// levels that ramps look up.
std::vector<Trait> infer_level_of_detail(std::span<const LookupScene> ramps,
                                         const RuleChoices& found);

// Measures how far one surface's levels of detail are from formulas of the exact texture
// coordinates: the formula that the renderer is found to follow, and all others in the catalogue,
// each a scale factor and a logarithm. Derivatives are those of the exact coordinates, by the
// method that the renderer is found to follow.
class ResidualTable {
 public:
  explicit ResidualTable(const RuleChoices& found) : found_(found) {}

  void add(RampKind kind, const std::string& id, const Scene& scene,
           const std::vector<FragmentLookup>& lookups);
  // In the order in which kinds were added; none for a source without reports.
  std::vector<LevelResiduals>& rows() { return rows_; }

 private:
  LevelResiduals& row(RampKind kind, LevelSource source);

  RuleChoices found_;
  std::vector<LevelResiduals> rows_;
};

// ------------------------------------------------------------------------------------- mip chains

// A whole chain that the renderer generated from one image.
struct GeneratedChain {
  TextureFormat format = TextureFormat::rgba8;
  std::vector<TextureLevel> levels;
};

// mipmap.filter, mipmap.rounding and mipmap.srgb: each level compared with the renderer's own
// previous one. Results for rgba8, and mipmap.srgb for srgb8, apply to all; traits with a format's
// name apply to that format only.
std::vector<Trait> infer_mip_chains(std::span<const GeneratedChain> chains);

extern const Subject kTextureSubject;

}  // namespace edgecase
