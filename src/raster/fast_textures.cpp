// SPDX-License-Identifier: MIT
#include "raster/fast_textures.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace edgecase {
namespace {

constexpr float kLargestCoordinate = 1024;
constexpr double kWidestWeight = 0x1p-30;

bool is_power_of_two(int size) {
  return std::has_single_bit(static_cast<unsigned>(size));
}

// Are coordinates and weights numbers without a grid, and wrap modes known?
bool is_known(const TextureUse& use, const TextureChoice& choice) {
  const auto is_wrap_known = [](Wrap wrap) {
    return wrap == Wrap::repeat || wrap == Wrap::clamp_to_edge;
  };
  return choice.texel_grid == TexelGrid::none && use.sampler.max_anisotropy == 1 &&
         std::all_of(use.sampler.wrap.begin(), use.sampler.wrap.end(), is_wrap_known);
}

bool are_near(const ScenePrimitive& triangle) {
  return std::all_of(triangle.vertices.begin(), triangle.vertices.end(), [](const Vertex* vertex) {
    return std::all_of(vertex->texture_coordinates.begin(), vertex->texture_coordinates.end(),
                       [](float value) { return std::abs(value) <= kLargestCoordinate; });
  });
}

// One word a texel; nothing where some are no codes of 8 bits.
std::optional<std::vector<PixelWord>> words_of(const TextureLevel& level) {
  std::vector<PixelWord> words;
  for (std::size_t i = 0; i < level.texels.size(); i += 4) {
    std::array<std::uint8_t, 4> codes{};
    for (std::size_t c = 0; c < 4; ++c) {
      const float texel = level.texels[i + c];
      if (!(texel >= 0 && texel <= 255 && texel == std::floor(texel))) return std::nullopt;
      codes[c] = static_cast<std::uint8_t>(texel);
    }
    words.push_back(std::bit_cast<PixelWord>(codes));
  }
  return words;
}

}  // namespace

FastTextures::FastTextures(const Scene& scene, const RuleChoices& choices)
    : scene_(scene), choices_(choices), stage_(scene, choices) {}

const TexelPlane* FastTextures::plane_of(std::size_t texture, int level) {
  const auto [entry, is_new] = planes_.try_emplace({texture, level});
  if (is_new) {
    const auto chain = stage_.chains().find(texture);
    const std::vector<TextureLevel>& levels =
        chain == stage_.chains().end() ? scene_.textures[texture]->levels : chain->second;
    const TextureLevel& image = levels.at(static_cast<std::size_t>(level));
    auto words = words_of(image);
    if (words && is_power_of_two(image.width) && is_power_of_two(image.height)) {
      words_.push_back(std::move(*words));
      entry->second = TexelPlane{words_.back().data(), image.width, image.height};
    }
  }
  return entry->second ? &*entry->second : nullptr;
}

std::optional<TexturedTriangle> FastTextures::looked_up(const ScenePrimitive& triangle) {
  const TextureUse& use = *triangle.state->texture;
  const TextureChoice& choice = choices_.textures;
  const Texture& texture = *scene_.textures[use.texture];
  if (!is_known(use, choice) || !are_near(triangle)) return std::nullopt;
  if (texture.format != TextureFormat::rgba8 || texture.dimensions != 2) return std::nullopt;

  // Any pixel: all have one level.
  const PrimitiveAttributes attributes = attributes_of(triangle, choices_, scene_.target);
  const Interval lambda = stage_.look_up(triangle, attributes, {0, 0}).lambda;
  const LevelRules rules{choice.crossover, choice.nearest_level, choice.level_weight, false, 0};
  const int last = last_level_of(stage_.decoded(use.texture), use.sampler, texture);
  const std::vector<LevelPick> picks = pick_levels(lambda, use.sampler, last, rules);
  if (picks.size() != 1 || picks[0].filter != Filter::linear) return std::nullopt;
  const LevelPick& pick = picks[0];
  const TexelPlane* const first = plane_of(use.texture, std::min(pick.level, last));
  const TexelPlane* const second = plane_of(use.texture, std::min(pick.next, last));
  if (!first || !second) return std::nullopt;

  TexturedTriangle result;
  result.levels = {*first, *second};
  if (pick.next != pick.level) {
    if (!(pick.weight.high - pick.weight.low < kWidestWeight)) return std::nullopt;
    result.weight = pick.weight.low;
    result.weight_margin = pick.weight.high - pick.weight.low;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [s, t] = triangle.vertices[i]->texture_coordinates;
    result.coordinates[i] = {s, t, 0, 0};
  }
  for (std::size_t c = 0; c < 2; ++c) result.repeats[c] = use.sampler.wrap[c] == Wrap::repeat;
  return result;
}

}  // namespace edgecase
