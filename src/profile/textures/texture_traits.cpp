// SPDX-License-Identifier: MIT
#include "profile/textures/texture_traits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "diff/values/value_diff.h"
#include "profile/tally.h"
#include "raster/texture_stage.h"

namespace edgecase {
namespace {

struct Candidate {
  std::string name;
  TextureChoice choice;
};
using Candidates = std::vector<Candidate>;

template <class Enum>
void add_candidates(std::span<const Enum> values, Enum TextureChoice::*member,
                    const TextureChoice& found, Candidates& candidates) {
  for (const Enum value : values) {
    candidates.push_back({name_of(value), found});
    candidates.back().choice.*member = value;
  }
}

Candidates candidates_of(TextureRule rule, const TextureChoice& found) {
  constexpr std::array kWraps{WrapChoice::as_set, WrapChoice::mirrored_as_repeat};
  constexpr std::array kAnisotropies{Anisotropy::extension, Anisotropy::gaussian_5,
                                     Anisotropy::none};
  Candidates candidates;
  switch (rule) {
    case TextureRule::level_weight:
      add_candidates(values_of<LevelWeight>(), &TextureChoice::level_weight, found, candidates);
      break;
    case TextureRule::texel_grid:
      add_candidates(values_of<TexelGrid>(), &TextureChoice::texel_grid, found, candidates);
      break;
    case TextureRule::wrap:
      add_candidates(std::span<const WrapChoice>(kWraps), &TextureChoice::wrap, found, candidates);
      break;
    case TextureRule::nearest_level:
      add_candidates(values_of<NearestLevel>(), &TextureChoice::nearest_level, found, candidates);
      break;
    case TextureRule::crossover:
      add_candidates(values_of<Crossover>(), &TextureChoice::crossover, found, candidates);
      break;
    case TextureRule::bias:
      add_candidates(values_of<BiasChoice>(), &TextureChoice::bias, found, candidates);
      break;
    case TextureRule::anisotropy:
      add_candidates(std::span<const Anisotropy>(kAnisotropies), &TextureChoice::anisotropy, found,
                     candidates);
      break;
  }
  return candidates;
}

// A float32 number that was interpolated in doubles may have lost its last place.
double as_float(double coordinate) {
  const double rounded = to_float(coordinate);
  return std::fabs(rounded - coordinate) <= 0x1p-45 * std::fabs(coordinate) ? rounded : coordinate;
}

// The lookups of one scene's primitives under one candidate.
class CandidateScene {
 public:
  CandidateScene(const Scene& scene, std::span<const ScenePrimitive> primitives,
                 const RuleChoices& found, const TextureChoice& choice)
      : primitives_(primitives), choices_(found), textured_(primitives.size()) {
    choices_.textures = choice;
    stage_ = std::make_unique<TextureStage>(scene, choices_);
    for (const ScenePrimitive& primitive : primitives)
      attributes_.push_back(attributes_of(primitive, choices_, scene.target));
  }
  CandidateScene(const CandidateScene&) = delete;
  CandidateScene& operator=(const CandidateScene&) = delete;

  // All colours that come out where the renderer looks, at the exact level of detail.
  std::vector<Texel> colors(const ToldLookup& told) {
    const auto number = static_cast<std::size_t>(told.primitive);
    const ScenePrimitive& primitive = primitives_[number];
    std::optional<TexturedPrimitive>& textured = textured_[number];
    if (!textured) textured.emplace(*stage_, primitive, attributes_[number]);
    const ExactLookup exact = textured->look_up(told.pixel);
    const TextureUse& use = *primitive.state->texture;
    TexturePoint point = exact.point;
    if (told.coordinates)
      point = {as_float((*told.coordinates)[0]), as_float((*told.coordinates)[1])};
    return sample(stage_->decoded(use.texture), *stage_->scene().textures[use.texture], use.sampler,
                  choices_.textures, {point, exact.lambda});
  }

 private:
  std::span<const ScenePrimitive> primitives_;
  RuleChoices choices_;
  std::unique_ptr<TextureStage> stage_;
  std::vector<PrimitiveAttributes> attributes_;
  std::vector<std::optional<TexturedPrimitive>> textured_;  // those that were asked for
};

bool is_code(double component) {
  const double code = component * 255;
  return std::fabs(code - std::nearbyint(code)) < 1e-3;
}

// Are all colours codes of 8 bits, as no filter in floats makes them?
bool are_codes(std::span<const ToldScene> scenes) {
  for (const ToldScene& scene : scenes) {
    if (scene.scene.textures[0]->format != TextureFormat::rgba8) return false;
    for (const ToldLookup& lookup : scene.lookups)
      if (!std::ranges::all_of(lookup.color, is_code)) return false;
  }
  return true;
}

// How far a told component may be from what an alternative makes of it.
double tolerance_of(TextureRule rule, std::span<const ToldScene> scenes) {
  // Half a code is what rounding to one takes.
  if (are_codes(scenes)) return (0.5 + 1e-3) / 255;
  // Vectors of anisotropic footprints are no short fractions.
  return rule == TextureRule::anisotropy ? 0x1p-8 : 0x1p-14;
}

bool yields(const std::vector<Texel>& colors, const std::array<double, 4>& told, double tolerance) {
  return std::ranges::any_of(colors, [&](const Texel& color) {
    for (std::size_t c = 0; c < told.size(); ++c)
      if (!(told[c] >= color[c].low - tolerance && told[c] <= color[c].high + tolerance))
        return false;
    return true;
  });
}

// Without those that do not concern the scenes' format.
Candidates candidates_for(TextureRule rule, std::span<const ToldScene> scenes,
                          const TextureChoice& found) {
  Candidates candidates = candidates_of(rule, found);
  const bool is_rgba8 =
      scenes.empty() || scenes[0].scene.textures[0]->format == TextureFormat::rgba8;
  if (rule == TextureRule::texel_grid && !is_rgba8)
    std::erase_if(candidates, [](const Candidate& candidate) {
      return candidate.choice.texel_grid == TexelGrid::linear_even_8;
    });
  return candidates;
}

std::vector<std::string> names_of(const Candidates& candidates) {
  std::vector<std::string> names;
  for (const Candidate& candidate : candidates) names.push_back(candidate.name);
  return names;
}

template <class Enum>
void adopt_into(const Trait& trait, const char* rule, Enum& value) {
  if (trait.id == rule) parse_name(trait.alternative, value);
}

}  // namespace

Trait infer_texture_rule(TextureRule rule, std::string id, std::span<const ToldScene> scenes,
                         const RuleChoices& found) {
  const Candidates candidates = candidates_for(rule, scenes, found.textures);
  const double tolerance = tolerance_of(rule, scenes);
  Tally tally(names_of(candidates), 0);
  for (const ToldScene& told : scenes) {
    const auto primitives = primitives_of(told.scene);
    std::vector<std::unique_ptr<CandidateScene>> ways;
    for (const Candidate& candidate : candidates)
      ways.push_back(
          std::make_unique<CandidateScene>(told.scene, primitives, found, candidate.choice));
    for (const ToldLookup& lookup : told.lookups) {
      std::vector<bool> agree;
      for (const auto& way : ways)
        agree.push_back(yields(way->colors(lookup), lookup.color, tolerance));
      tally.add(agree);
    }
  }
  // Nothing of anisotropic filters is laid down: what is not catalogued must not be overlooked.
  return tally.trait(std::move(id), rule == TextureRule::anisotropy ? Tally::None::counted
                                                                    : Tally::None::remarked);
}

void adopt(const Trait& trait, TextureChoice& choice) {
  if (trait.rate.of == 0) return;
  adopt_into(trait, name_of(RuleId::texture_wrap), choice.wrap);
  adopt_into(trait, name_of(RuleId::texture_texel_grid), choice.texel_grid);
  adopt_into(trait, name_of(RuleId::texture_scale_factor), choice.scale_factor);
  adopt_into(trait, name_of(RuleId::texture_log2), choice.log2);
  adopt_into(trait, name_of(RuleId::texture_derivatives), choice.derivatives);
  adopt_into(trait, name_of(RuleId::texture_lod_bias), choice.bias);
  adopt_into(trait, name_of(RuleId::texture_crossover), choice.crossover);
  adopt_into(trait, name_of(RuleId::texture_nearest_level), choice.nearest_level);
  adopt_into(trait, name_of(RuleId::texture_level_weight), choice.level_weight);
  adopt_into(trait, name_of(RuleId::texture_anisotropy), choice.anisotropy);
  adopt_into(trait, name_of(RuleId::mipmap_filter), choice.mipmap.filter);
  adopt_into(trait, name_of(RuleId::mipmap_rounding), choice.mipmap.rounding);
  if (trait.id == name_of(RuleId::mipmap_srgb)) parse_name(trait.alternative, choice.mipmap.srgb);
}

}  // namespace edgecase
