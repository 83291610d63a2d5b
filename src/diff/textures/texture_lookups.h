// SPDX-License-Identifier: MIT
//
// What the lookups of a rendering's fragments may yield: exactly, under any choice with inexact
// operations, and at most by what the specification permits (rulings 19 to 24).
//
// Coordinates are the renderer's own where it tells them, so that an error of interpolation, judged
// by ruling 9, is not counted again as one of texturing.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "diff/textures/exact_lookups.h"
#include "diff/textures/texture_ways.h"
#include "diff/values/value_diff.h"
#include "rules/textures/precision.h"
#include "rules/values/derivative.h"

namespace edgecase {

// Boxes, in any of which all components of a lookup may lie: of a colour four, of a level of detail
// two, the level accessed (0 the base level) and lambda' before clamping, as textureQueryLod has
// them.
using Boxes = std::vector<std::vector<Interval>>;

class TextureLookups {
 public:
  // All must outlive this.
  TextureLookups(const ValueContext& context, const Rendering& exact, const Rendering& rendered);

  // Of the rendering's own fragments of textured draws. Under the policy, exactly:
  LookedUp exact(const Fragment& fragment) { return exact_.look_up(fragment); }

  // Under a choice, every operation inexact.
  Boxes levels(const Fragment& fragment, const TextureChoice& choice);
  // `rounding`: means may besides be rounded to codes of 8 bits, where the format has them.
  // `as_told`: of the level of detail that the renderer tells, which must tell it.
  Boxes colors(const Fragment& fragment, const TextureChoice& choice, bool rounding, bool as_told);
  bool may_round(const Fragment& fragment) const;
  // Does a choice lead to a level at all? Not where the derivatives that it takes nearly cancel:
  // then the scale factor may be anything down to zero, and would explain every level. Where they
  // are exactly zero it explains the logarithm of 0, and no other.
  bool is_definite(const Fragment& fragment, const TextureChoice& choice, bool is_query);

  // By what the specification permits: anything, or quicker and short of that, with vertices where
  // they are; or beyond it what is contested alone.
  enum class Reach { near, all, coarse, coarse_srgb };
  Boxes permitted_levels(const Fragment& fragment, Reach reach = Reach::all);
  Boxes permitted_colors(const Fragment& fragment, Reach reach = Reach::all);
  // Of the level of detail only lambda'.
  Interval permitted_lambda(const Fragment& fragment, Reach reach = Reach::all);

  // Is each level that an anisotropic filter may access of one colour?
  bool has_levels_of_one_color(const Fragment& fragment) const;

  // Drops what is kept of a fragment in case that it is asked for again.
  void forget(const Fragment& fragment) { fragments_.erase(&fragment); }

  const TextureUse& use_of(const Fragment& fragment) const;
  const Texture& texture_of(const Fragment& fragment) const;
  const FragmentDetail* detail_of(const Fragment& fragment) const;
  LookupKinship kinship_of(const Fragment& fragment, bool is_query) const;
  // Does the renderer tell the level of this very lookup?
  bool tells_level(const Fragment& fragment) const;

 private:
  // Per pixel, of s and t.
  struct Gradients {
    IntervalPair dx;
    IntervalPair dy;
  };
  // What is worked out once for a fragment.
  struct OfFragment {
    std::vector<std::pair<DerivativeMethod, Gradients>> gradients;
  };

  static SamplerPrecision precision_within(Reach reach);
  Gradients gradients_of(const Fragment& fragment, DerivativeMethod method);
  Gradients permitted_gradients(const Fragment& fragment, Reach reach);
  Gradients asked_gradients(const Fragment& fragment) const;
  Gradients lookup_gradients(const Fragment& fragment, DerivativeMethod method);
  Footprint footprint_of(const Fragment& fragment, const Gradients& gradients) const;
  Interval permitted_scale(const Footprint& footprint) const;
  TexturePoint point_of(const Fragment& fragment, const PrimitiveAttributes& attributes,
                        double error) const;
  Interval lookup_lambda(const Fragment& fragment, Interval scale_factor,
                         const TextureChoice& choice) const;
  Interval permitted_lookup_lambda(const Fragment& fragment, Reach reach);
  std::vector<Texel> permitted_samples(const Fragment& fragment, Reach reach);
  int last_accessible(const Fragment& fragment) const;
  Texel accessible_texels(const Fragment& fragment) const;
  std::optional<Interval> told_lambda(const Fragment& fragment) const;
  Boxes level_boxes(const Fragment& fragment, Interval lambda_prime, const LevelRules& rules) const;
  std::vector<Texel> told_colors(const Fragment& fragment, const TextureChoice& choice) const;
  std::vector<Texel> probed_colors(const Fragment& fragment, const TextureChoice& choice);
  Texel weighted_probes(const Fragment& fragment, const TextureChoice& choice,
                        const Gradients& gradients, const ProbeRow& row) const;
  bool has_unknown_coordinates(const Fragment& fragment) const;
  bool has_unknown_chain(const Fragment& fragment) const;
  double largest_of(const TextureUse& use) const;
  Boxes widened(const Fragment& fragment, const std::vector<Texel>& colors, bool rounding,
                double of_srgb = 0) const;

  const ValueContext& context_;
  const Rendering& rendered_;
  ExactLookups exact_;
  std::vector<double> magnitudes_;              // of each texture's numbers
  std::map<std::size_t, DecodedTexture> srgb_;  // of sRGB textures, not decoded; when asked for
  std::vector<std::optional<PermittedDerivatives>> primitives_;  // of s and of t
  InexactDerivatives inexact_;
  std::map<const Fragment*, OfFragment> fragments_;
};

}  // namespace edgecase
