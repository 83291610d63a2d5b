// SPDX-License-Identifier: MIT
#include "profile/textures/texture_levels.h"

#include <algorithm>
#include <cmath>

namespace edgecase {

const char* name_of(LevelSource source) {
  return source == LevelSource::query ? "textureQueryLod" : "looked up";
}

RampLevels::RampLevels(const Scene& scene, const RuleChoices& found)
    : scene_(scene), found_(found) {
  for (const ScenePrimitive& primitive : primitives_of(scene))
    attributes_.push_back(attributes_of(primitive, found, scene.target));
  last_ = static_cast<double>(scene.textures[0]->levels.size()) - 1;
}

template <class Derivative>
Footprint RampLevels::footprint_by(const Derivative& derivative) const {
  const Texture& texture = *scene_.textures[0];
  const TextureLevel& base = texture.levels[0];
  return footprint({derivative(0, Axis::x), derivative(1, Axis::x)},
                   {derivative(0, Axis::y), derivative(1, Axis::y)}, base.width, base.height,
                   texture.dimensions);
}

Footprint RampLevels::exact_footprint(const ToldLookup& lookup, DerivativeMethod method) const {
  const auto& color = attributes_[static_cast<std::size_t>(lookup.primitive)].color;
  const QuadPixel at = quad_of(lookup.pixel, found_.values, scene_.target);
  return footprint_by(
      [&](std::size_t c, Axis axis) { return derivative_exact(color[c], at, axis, method); });
}

Footprint RampLevels::rounded_footprint(const ToldLookup& lookup, DerivativeMethod method) const {
  // An operation of float32 errs by 2^-24, of what 2.3.1 allows, 10^-5, not a hundredth; how many
  // operations there are is not known.
  constexpr double kShare = 0x1p-4;
  const auto& color = attributes_[static_cast<std::size_t>(lookup.primitive)].color;
  const QuadPixel at = quad_of(lookup.pixel, found_.values, scene_.target);
  return footprint_by([&](std::size_t c, Axis axis) {
    const Interval exact = derivative_exact(color[c], at, axis, method);
    const Interval inexact = derivative_inexact(color[c], at, axis, method);
    return Interval(exact.low - kShare * (exact.low - inexact.low),
                    exact.high + kShare * (inexact.high - exact.high));
  });
}

std::optional<double> RampLevels::told(const ToldLookup& lookup, LevelSource source) const {
  if (source == LevelSource::color) return lookup.color[0];
  return lookup.lambda_prime;
}

Interval RampLevels::tellable(Interval lambda_base, LevelSource source) const {
  const TextureUse& use = *scene_.draws[0].texture;
  const Interval lambda_prime =
      with_bias(lambda_base, use.sampler, use.lookup, found_.textures.bias);
  if (source == LevelSource::query) return lambda_prime;
  const TextureChoice& choice = found_.textures;
  const LevelRules rules{choice.crossover, choice.nearest_level, choice.level_weight, false, 0};
  return accessed_level(clamped(lambda_prime, use.sampler), use.sampler, static_cast<int>(last_),
                        rules);
}

bool RampLevels::are_ends(double a, double b, LevelSource source) const {
  return source == LevelSource::color && a == b && (a == 0 || a == last_);
}

}  // namespace edgecase
