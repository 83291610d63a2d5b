// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diff/values/value_diff.h"
#include "profile/evidence/inference.h"
#include "profile/textures/textures.h"
#include "raster/texture_stage.h"

namespace edgecase {
namespace {

// A float32 number that was interpolated in doubles may have lost its last bits.
double as_float(double coordinate) {
  const double rounded = to_float(coordinate);
  return std::fabs(rounded - coordinate) <= 0x1p-45 * std::fabs(coordinate) ? rounded : coordinate;
}

// The lookups of one scene's primitives under one candidate.
class CandidateScene {
 public:
  CandidateScene(const Scene& scene, std::span<const ScenePrimitive> primitives,
                 const RuleChoices& choices)
      : primitives_(primitives), choices_(choices), textured_(primitives.size()) {
    stage_ = std::make_unique<TextureStage>(scene, choices_);
    for (const ScenePrimitive& primitive : primitives)
      attributes_.push_back(attributes_of(primitive, choices_, scene.target));
  }
  CandidateScene(const CandidateScene&) = delete;
  CandidateScene& operator=(const CandidateScene&) = delete;

  // All colours of the renderer's lookup, at the exact level of detail.
  Texels colors(const FragmentLookup& lookup) {
    const auto number = static_cast<std::size_t>(lookup.primitive);
    const ScenePrimitive& primitive = primitives_[number];
    std::optional<TexturedPrimitive>& textured = textured_[number];
    if (!textured) textured.emplace(*stage_, primitive, attributes_[number]);
    const ExactLookup exact = textured->look_up(lookup.pixel);
    const TextureUse& use = *primitive.state->texture;
    TexturePoint point = exact.point;
    if (lookup.coordinates)
      point = {as_float((*lookup.coordinates)[0]), as_float((*lookup.coordinates)[1])};
    return sample(stage_->decoded(use.texture), *stage_->scene().textures[use.texture], use.sampler,
                  choices_.textures, {point, exact.lambda});
  }

 private:
  std::span<const ScenePrimitive> primitives_;
  RuleChoices choices_;
  std::unique_ptr<TextureStage> stage_;
  std::vector<PrimitiveAttributes> attributes_;
  std::vector<std::optional<TexturedPrimitive>> textured_;  // created on demand
};

bool is_code(double component) {
  const double code = component * 255;
  return std::fabs(code - std::nearbyint(code)) < 1e-3;
}

// Whether all colours are 8-bit codes, unlike results of filtering in floats.
bool are_codes(std::span<const LookupScene> scenes) {
  for (const LookupScene& scene : scenes) {
    if (scene.scene.textures[0]->format != TextureFormat::rgba8) return false;
    for (const FragmentLookup& lookup : scene.lookups)
      if (!std::ranges::all_of(lookup.color, is_code)) return false;
  }
  return true;
}

// The permitted distance of a component from that of an alternative.
double tolerance_of(RuleId rule, std::span<const LookupScene> scenes) {
  // Rounding to a code takes half a code.
  if (are_codes(scenes)) return (0.5 + 1e-3) / 255;
  // Vectors of anisotropic footprints are not short fractions.
  return rule == RuleId::texture_anisotropy ? 0x1p-8 : 0x1p-14;
}

bool yields(const Texels& colors, const std::array<double, 4>& rendered, double tolerance) {
  return std::ranges::any_of(colors, [&](const Texel& color) {
    for (std::size_t c = 0; c < rendered.size(); ++c)
      if (!(rendered[c] >= color[c].low - tolerance && rendered[c] <= color[c].high + tolerance))
        return false;
    return true;
  });
}

// The alternatives that concern the scenes' format.
std::vector<std::string> candidates_of(RuleId rule, std::span<const LookupScene> scenes) {
  std::vector<std::string> names = names_of_alternatives(rule);
  const bool is_rgba8 =
      scenes.empty() || scenes[0].scene.textures[0]->format == TextureFormat::rgba8;
  if (rule == RuleId::texture_texel_grid && !is_rgba8)
    std::erase(names, name_of(TexelGrid::linear_even_8));
  return names;
}

// A step that visits a whole list without following its rows or columns.
std::size_t spreading_step(std::size_t count) {
  auto step = static_cast<std::size_t>(0.618 * static_cast<double>(count));
  while (step > 1 && std::gcd(step, count) != 1) --step;
  return std::max<std::size_t>(step, 1);
}

}  // namespace

std::vector<FragmentLookup> lookups_of(const Rendering& rendering, std::size_t most) {
  std::vector<FragmentLookup> result;
  const std::size_t count = rendering.fragments.size();
  const std::size_t taken = std::min(count, most);
  const std::size_t step = taken == count ? 1 : spreading_step(count);
  for (std::size_t i = 0; i < taken; ++i) {
    const Fragment& fragment = rendering.fragments[i * step % count];
    if (!fragment.has_color) continue;
    FragmentLookup lookup;
    lookup.pixel = {fragment.x, fragment.y};
    lookup.primitive = fragment.primitive;
    lookup.color = fragment.color;
    if (fragment.detail >= 0) {
      const FragmentDetail& detail = rendering.details[static_cast<std::size_t>(fragment.detail)];
      lookup.coordinates = detail.texture_coordinates;
      if (detail.level_of_detail) lookup.lambda_prime = (*detail.level_of_detail)[1];
    }
    result.push_back(lookup);
  }
  return result;
}

Trait infer_texture_rule(const TraitId& id, std::span<const LookupScene> scenes,
                         const RuleChoices& found) {
  const std::vector<std::string> names = candidates_of(id.rule, scenes);
  const double tolerance = tolerance_of(id.rule, scenes);
  Tally tally(names);
  for (const LookupScene& scene : scenes) {
    const auto primitives = primitives_of(scene.scene);
    std::vector<std::unique_ptr<CandidateScene>> candidates;
    for (const std::string& name : names)
      candidates.push_back(std::make_unique<CandidateScene>(
          scene.scene, primitives, with_alternative(found, id.rule, name)));
    for (const FragmentLookup& lookup : scene.lookups) {
      std::vector<bool> agree;
      for (const auto& candidate : candidates)
        agree.push_back(yields(candidate->colors(lookup), lookup.color, tolerance));
      tally.add(agree);
    }
  }
  // The specification does not define anisotropic filters, so a lookup that no catalogued one
  // yields must not be overlooked.
  return tally.trait(
      id, id.rule == RuleId::texture_anisotropy ? Tally::None::counted : Tally::None::remarked);
}

namespace {

constexpr auto kSrgb = values_of<MipmapSrgb>();

// A method, as indices of its parts in the catalogue's tables.
struct Parts {
  std::size_t filter = 0;
  std::size_t rounding = 0;
  std::size_t srgb = 0;

  MipmapMethod method() const {
    return {values_of<MipmapFilter>()[filter], values_of<MipmapRounding>()[rounding], kSrgb[srgb]};
  }
  std::size_t index() const {
    return (filter * values_of<MipmapRounding>().size() + rounding) * kSrgb.size() + srgb;
  }
};

std::vector<Parts> all_parts() {
  std::vector<Parts> result;
  for (std::size_t f = 0; f < values_of<MipmapFilter>().size(); ++f)
    for (std::size_t r = 0; r < values_of<MipmapRounding>().size(); ++r)
      for (std::size_t s = 0; s < kSrgb.size(); ++s) result.push_back({f, r, s});
  return result;
}

// Which methods yield one component of a texel.
using Yields = std::vector<bool>;

// Floats from 0 to 1 may err as float32 arithmetic does.
bool is_same(float rendered, float made, TextureFormat format) {
  return holds_floats(format) ? std::fabs(rendered - made) <= 0x1p-19f : rendered == made;
}

void add_yields(const GeneratedChain& chain, std::vector<Yields>& all) {
  for (std::size_t k = 1; k < chain.levels.size(); ++k) {
    const std::vector<float>& rendered = chain.levels[k].texels;
    std::vector<TextureLevel> made;
    for (const Parts& parts : all_parts())
      made.push_back(reduced(chain.levels[k - 1], chain.format, parts.method()));
    for (std::size_t i = 0; i < rendered.size(); ++i) {
      Yields yields;
      for (const TextureLevel& level : made)
        yields.push_back(i < level.texels.size() &&
                         is_same(rendered[i], level.texels[i], chain.format));
      all.push_back(std::move(yields));
    }
  }
}

// Among equals, the first.
Parts best_of(const std::vector<Yields>& all) {
  std::vector<std::size_t> counts(all_parts().size());
  for (const Yields& yields : all)
    for (std::size_t i = 0; i < yields.size(); ++i)
      if (yields[i]) ++counts[i];
  Parts best;
  for (const Parts& parts : all_parts())
    if (counts[parts.index()] > counts[best.index()]) best = parts;
  return best;
}

// One rule, with the two others as in the best method.
Trait trait_of(TraitId id, std::size_t Parts::*part, const Parts& best,
               const std::vector<Yields>& all) {
  Tally tally(names_of_alternatives(id.rule), best.*part);
  for (const Yields& yields : all) {
    Yields agree;
    for (std::size_t i = 0; i < names_of_alternatives(id.rule).size(); ++i) {
      Parts other = best;
      other.*part = i;
      agree.push_back(yields[other.index()]);
    }
    tally.add(agree);
  }
  Trait trait = tally.trait(std::move(id));
  if (all.empty()) trait.remark = "no chain is reported";
  return trait;
}

}  // namespace

std::vector<Trait> infer_mip_chains(std::span<const GeneratedChain> chains) {
  std::vector<Trait> traits;
  for (const TextureFormat format : kTextureFormats) {
    std::vector<Yields> all;
    for (const GeneratedChain& chain : chains)
      if (chain.format == format) add_yields(chain, all);
    const Parts best = best_of(all);
    const std::string probe = probe_of(format);
    traits.push_back(trait_of({RuleId::mipmap_filter, probe}, &Parts::filter, best, all));
    if (!holds_floats(format))
      traits.push_back(trait_of({RuleId::mipmap_rounding, probe}, &Parts::rounding, best, all));
    if (format == TextureFormat::srgb8)
      traits.push_back(trait_of(RuleId::mipmap_srgb, &Parts::srgb, best, all));
  }
  return traits;
}

}  // namespace edgecase
