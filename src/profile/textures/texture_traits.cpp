// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "diff/values/value_diff.h"
#include "profile/evidence/tally.h"
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
  std::vector<Texel> colors(const FragmentLookup& lookup) {
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

bool yields(const std::vector<Texel>& colors, const std::array<double, 4>& rendered,
            double tolerance) {
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

}  // namespace edgecase
