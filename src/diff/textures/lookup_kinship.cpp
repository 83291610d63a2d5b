// SPDX-License-Identifier: MIT
#include "diff/textures/lookup_kinship.h"

#include <cmath>
#include <cstdio>

namespace edgecase {
namespace {

constexpr TextureChoice kPlain;

bool mirrors(const LookupKinship& kin) {
  const auto& wrap = kin.use->sampler.wrap;
  return wrap[0] == Wrap::mirrored_repeat ||
         (kin.texture->dimensions == 2 && wrap[1] == Wrap::mirrored_repeat);
}

// True if a filter within a level puts coordinates on this grid.
bool shows_grid(TexelGrid grid, const LookupKinship& kin) {
  const Sampler& sampler = kin.use->sampler;
  const bool is_linear = sampler.magnify == Filter::linear || sampler.minify == Filter::linear;
  return grid != TexelGrid::linear_even_8 ||
         (is_linear && kin.texture->format == TextureFormat::rgba8);
}

// True if versions of OpenGL differ about where these filters change over.
bool has_disputed_crossover(const Sampler& sampler) {
  return sampler.magnify == Filter::linear && sampler.minify == Filter::nearest &&
         sampler.mipmap != MipFilter::none;
}

bool shows_bias(BiasChoice bias, const LookupKinship& kin) {
  const auto of_sampler = static_cast<double>(kin.use->sampler.lod_bias);
  const Lookup& lookup = kin.use->lookup;
  const bool asks_bias = !kin.is_query && lookup.kind == LookupKind::bias;
  const bool has_gradients = !kin.is_query && lookup.kind == LookupKind::gradients;
  const double sum = of_sampler + (asks_bias ? static_cast<double>(lookup.value) : 0);
  switch (bias) {
    case BiasChoice::as_set:
      return false;
    case BiasChoice::sampler_nearest_8:
      return of_sampler * 256 != std::floor(of_sampler * 256);
    case BiasChoice::unclamped:
      return !(std::fabs(sum) <= kMaxLodBias);
    case BiasChoice::not_of_gradients:
      return has_gradients && of_sampler != 0;
    case BiasChoice::half_a_level_more:
      return true;
  }
  return true;
}

bool shows_limits(LevelLimits limits, const LookupKinship& kin) {
  const Sampler& sampler = kin.use->sampler;
  const Sampler meant = limited(sampler, limits);
  // From level 0 on, both limits end at the same level; a level of detail of 0 is magnified.
  if (limits == LevelLimits::max_level_as_max_lod && sampler.base_level == 0 &&
      sampler.max_level > 0)
    return false;
  return meant != sampler;
}

// Removes the choices by which a footprint determines a level.
void drop_scale(TextureChoice& choice) {
  choice.scale_factor = kPlain.scale_factor;
  choice.log2 = kPlain.log2;
  choice.derivatives = kPlain.derivatives;
}

void drop_level(TextureChoice& choice) {
  choice.bias = kPlain.bias;
  choice.crossover = kPlain.crossover;
  choice.nearest_level = kPlain.nearest_level;
  choice.level_weight = kPlain.level_weight;
  choice.limits = kPlain.limits;
}

void drop_texels(TextureChoice& choice) {
  choice.wrap = kPlain.wrap;
  choice.texel_grid = kPlain.texel_grid;
  choice.crossover = kPlain.crossover;
}

}  // namespace

bool shows_level(const LookupKinship& kin) {
  const Sampler& sampler = kin.use->sampler;
  return kin.is_query || sampler.mipmap != MipFilter::none || sampler.magnify != sampler.minify;
}

TextureChoice relevant_part(const TextureChoice& given, const LookupKinship& kin) {
  TextureChoice choice = given;
  const Sampler& sampler = kin.use->sampler;
  const LookupKind asked = kin.is_query ? LookupKind::implicit : kin.use->lookup.kind;
  choice.level_count = kPlain.level_count;
  choice.mipmap = kPlain.mipmap;
  if (kin.is_query) drop_texels(choice);
  if (!mirrors(kin)) choice.wrap = kPlain.wrap;
  if (!shows_grid(choice.texel_grid, kin)) choice.texel_grid = kPlain.texel_grid;
  if (!has_disputed_crossover(sampler)) choice.crossover = kPlain.crossover;
  if (!shows_bias(choice.bias, kin)) choice.bias = kPlain.bias;
  if (!shows_limits(choice.limits, kin)) choice.limits = kPlain.limits;
  if (sampler.mipmap != MipFilter::nearest) choice.nearest_level = kPlain.nearest_level;
  if (sampler.mipmap != MipFilter::linear) choice.level_weight = kPlain.level_weight;
  if (!(sampler.max_anisotropy > 1) || asked == LookupKind::lod)
    choice.anisotropy = Anisotropy::none;
  if (choice.anisotropy != Anisotropy::none) choice.scale_factor = kPlain.scale_factor;
  const bool has_footprint = asked == LookupKind::implicit || asked == LookupKind::bias;
  if (!has_footprint || !kin.has_perspective) choice.derivatives = kPlain.derivatives;
  if (asked == LookupKind::lod || kin.is_level_given) drop_scale(choice);
  if (kin.is_level_given) choice.bias = kPlain.bias;
  if (!shows_level(kin)) {
    drop_level(choice);
    if (choice.anisotropy == Anisotropy::none) drop_scale(choice);
  }
  return choice;
}

}  // namespace edgecase
