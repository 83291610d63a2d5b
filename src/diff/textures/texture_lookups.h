// SPDX-License-Identifier: MIT
//
// The results that the lookups of a rendering's fragments may have: exact, under any choice with
// inexact operations, and the most that the specification permits (rulings 19 to 24).
//
// Coordinates are the renderer's own if it reports them, so that an error of interpolation, judged
// by ruling 9, does not count again as one of texturing.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "diff/textures/lookup_kinship.h"
#include "diff/values/drawn_fragments.h"
#include "diff/values/value_diff.h"
#include "raster/texture_stage.h"
#include "rules/textures/texel_filter.h"
#include "rules/values/coordinate_pairs.h"

namespace edgecase {

// The exact lookups of a rendering's fragments under a policy, and the texels that they use.
//
// A generated chain that the renderer reports is used as it is: compare_mip_chains reports its
// differences, once.

// A lookup in the form that Rendering has.
struct LookedUp {
  std::array<double, 2> level_of_detail{};  // as FragmentDetail::level_of_detail
  std::array<double, 4> color{};
};

class ExactLookups {
 public:
  // Everything referred to must outlive this. `exact`: the context's policy, in part or whole.
  ExactLookups(const ValueContext& context, const Rendering& exact, const Rendering& rendered);

  // The texels of the scene's textures in which the renderer looked up.
  const DecodedTexture& decoded(std::size_t texture) const;

  // The exact lookup of a fragment of a textured draw; its level of detail only if the renderer
  // reports one. Taken from exact's fragment if there is one with the same texels; else computed.
  LookedUp look_up(const Fragment& fragment);

 private:
  const Fragment* drawn(const Fragment& fragment);
  TexturedPrimitive& primitive_of(const Fragment& fragment);
  std::size_t texture_of(const Fragment& fragment) const;

  const ValueContext& context_;
  const Rendering& exact_;
  DrawnFragments drawn_;
  const Rendering& rendered_;
  TextureStage stage_;
  std::set<std::size_t> changed_;  // textures with the renderer's chains in place of exact's
  // The renderer's chains whose sizes are wrong, by texture index.
  std::map<std::size_t, DecodedTexture> own_;
  std::vector<std::unique_ptr<TexturedPrimitive>> primitives_;  // for lookups computed here
};

// Boxes in which all components of a lookup may lie: four components of a colour, two of a level of
// detail, namely the level accessed (0 the base level) and lambda' before clamping, as in
// textureQueryLod.
using Box = boost::container::static_vector<Interval, 4>;
using Boxes = boost::container::small_vector<Box, 2>;
// What a renderer reports of a lookup: as many numbers as a box has intervals.
using LookupNumbers = boost::container::static_vector<double, 4>;

// True if one of the boxes holds the float32 numbers. If everything is permitted, so is NaN.
bool hold(const Boxes& boxes, const LookupNumbers& numbers);
// Describes the smallest box around all others: "1 to 2, 0.5 to 0.75".
std::string describe_range(const Boxes& boxes);

class TextureLookups {
 public:
  // Everything referred to must outlive this.
  TextureLookups(const ValueContext& context, const Rendering& exact, const Rendering& rendered);

  // For the rendering's own fragments of textured draws. The exact result under the policy:
  LookedUp exact(const Fragment& fragment) { return exact_.look_up(fragment); }

  // Results under a choice with every operation inexact.
  Boxes levels(const Fragment& fragment, const TextureChoice& choice);
  // Colours before the errors of the filter's operations. `as_reported`: by the level of detail
  // that the renderer reports; it must report one.
  Texels colors(const Fragment& fragment, const TextureChoice& choice, bool as_reported);
  // With these errors. `rounding`: means may also be rounded to codes of 8 bits, if the format has
  // them; `of_srgb`: further error of red, green and blue of an sRGB texture.
  Boxes widened(const Fragment& fragment, const Texels& colors, bool rounding,
                double of_srgb = 0) const;
  bool may_round(const Fragment& fragment) const { return draw_of(fragment).codes > 0; }
  // True if a choice determines a level. It does not where the derivatives that it takes nearly
  // cancel: then the scale factor may be anything down to zero, and would explain every level.
  // Where they are exactly zero it explains the logarithm of 0, and no other.
  bool is_definite(const Fragment& fragment, const TextureChoice& choice, bool is_query);

  // How far a permitted result may reach: `all` of the specification's latitude; `near`, a quick
  // test with vertices where they are; or beyond it, what is contested.
  enum class Reach { near, all, coarse, coarse_srgb };
  Boxes permitted_levels(const Fragment& fragment, Reach reach = Reach::all);
  Boxes permitted_colors(const Fragment& fragment, Reach reach = Reach::all);
  // For a level of detail, only lambda'.
  Interval permitted_lambda(const Fragment& fragment, Reach reach = Reach::all);

  // Beyond the permitted colours by their range, in each component: what filters with negative
  // weights may make of them.
  Boxes overshooting_colors(const Fragment& fragment);

  // True if each level that an anisotropic filter may access has one colour.
  bool has_levels_of_one_color(const Fragment& fragment) const;

  // Drops cached data of a fragment, kept in case that it is needed again.
  void forget(const Fragment& fragment);

  const TextureUse& use_of(const Fragment& fragment) const { return *draw_of(fragment).use; }
  const Texture& texture_of(const Fragment& fragment) const { return *draw_of(fragment).texture; }
  const FragmentDetail* detail_of(const Fragment& fragment) const;
  LookupKinship kinship_of(const Fragment& fragment, bool is_query) const;
  // True if the renderer reports the level of this very lookup.
  bool reports_level(const Fragment& fragment) const;

 private:
  // Of s and t, per pixel.
  struct Gradients {
    IntervalPair dx;
    IntervalPair dy;
  };
  // Computed once for the lookups of a draw.
  struct OfDraw {
    const TextureUse* use = nullptr;
    const Texture* texture = nullptr;
    const DecodedTexture* decoded = nullptr;
    int last = 0;       // the last level used, as last_level_of
    double margin = 0;  // the error of a filter's operations
    double codes = 0;   // half a code for each mean that may be rounded to one
  };
  // Computed once for a fragment.
  struct OfFragment {
    boost::container::small_vector<std::pair<DerivativeMethod, Gradients>, 1> gradients;
  };

  OfDraw of_draw(const Draw& draw) const;
  const OfDraw& draw_of(const Fragment& fragment) const {
    return draws_[static_cast<std::size_t>(context_.primitive_of(fragment).draw)];
  }
  OfFragment& kept_of(const Fragment& fragment);
  static SamplerPrecision precision_within(Reach reach);
  Gradients gradients_of(const Fragment& fragment, DerivativeMethod method);
  Gradients quad_gradients(const Fragment& fragment);
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
  Texels permitted_samples(const Fragment& fragment, Reach reach);
  int last_accessible(const Fragment& fragment) const;
  Texel accessible_texels(const Fragment& fragment) const;
  std::optional<Interval> reported_lambda(const Fragment& fragment) const;
  Boxes level_boxes(const Fragment& fragment, Interval lambda_prime, const LevelRules& rules,
                    LevelLimits limits = LevelLimits::as_set) const;
  Texels colors_at_reported_level(const Fragment& fragment, const TextureChoice& choice) const;
  Texels probed_colors(const Fragment& fragment, const TextureChoice& choice);
  Texel weighted_probes(const Fragment& fragment, const TextureChoice& choice,
                        const Gradients& gradients, const ProbeRow& row) const;
  bool has_unknown_coordinates(const Fragment& fragment) const;
  bool has_unknown_chain(const Fragment& fragment) const;
  Texel texels_of_unknown_chain(const Fragment& fragment) const;

  const ValueContext& context_;
  const Rendering& rendered_;
  ExactLookups exact_;
  std::vector<OfDraw> draws_;                   // those without a texture are left out
  std::map<std::size_t, DecodedTexture> srgb_;  // of sRGB textures, not decoded; made on demand
  std::vector<std::optional<PermittedDerivatives>> primitives_;  // of s and of t
  InexactCoordinates inexact_;
  std::deque<OfFragment> kept_;
  std::vector<std::uint32_t> places_;  // by fragment: its place in kept_ from 1 on, or 0
  std::vector<std::uint32_t> free_;    // places of fragments that are forgotten
};

// Compares texture lookups of fragments with exact and with what the specification permits: the
// level of detail that the renderer reports (rulings 19 to 22), the colours that it looked up
// (rulings 20 to 24) and the mip chains that it made (ruling 25).
//
// Results of an open way are aggregated, one aggregate for each way with the way as its cause: a
// renderer that approximates the logarithm does so at every fragment. A result of an illegal way
// only, or of none and not permitted, is a disagreement of its own.

// Each appends disagreements and aggregates to `result`. `profile`: the choices that the renderer
// is measured to follow; null: unknown.
void compare_texture_lookups(const ValueContext& context, const Rendering& exact,
                             const Rendering& rendered, const TextureChoice* profile,
                             Result& result);

void compare_mip_chains(const ValueContext& context, const Rendering& exact,
                        const Rendering& rendered, Result& result);

}  // namespace edgecase
