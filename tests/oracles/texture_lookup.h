// SPDX-License-Identifier: MIT
//
// Texture lookups as the specification writes them (GL 4.6 core, 8.14 and 8.15), in fractions
// without a bound on their size. Written from its text alone, and slow.
//
// Fractions hold everything but logarithms and the sRGB curve, which come with 50 digits.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <vector>

#include "model/texture.h"

namespace edgecase::oracle {

using Fraction = boost::multiprecision::cpp_rational;
using FractionColor = std::array<Fraction, 4>;

// How a lookup goes where the specification leaves it open, or a policy departs from it.
struct LookupWays {
  bool crossover_at_half = false;  // where magnification is linear and minification is nearest
  bool up_at_ties = false;         // of levels that are equally near
};

struct TextureQuery {
  const Texture& texture;
  const std::vector<TextureLevel>& levels;
  const Sampler& sampler;
  LookupWays ways;
};

// Derivatives of s and t per pixel.
struct Gradients {
  std::array<Fraction, 2> dx;
  std::array<Fraction, 2> dy;
};

// lambda, which may be minus infinity.
struct LevelOfDetail {
  bool is_infinite = false;
  Fraction value;
};

// Of the longer of the two vectors.
LevelOfDetail log2_of_scale(const TextureQuery& query, const Gradients& gradients);
// lambda' and lambda. `shader_bias`: 0 where the shader gives none.
LevelOfDetail with_bias(LevelOfDetail base, const Sampler& sampler, float shader_bias);
Fraction clamped(const LevelOfDetail& lambda_prime, const Sampler& sampler);
// The level that textureQueryLod tells.
Fraction accessed(const TextureQuery& query, const Fraction& lambda);

FractionColor look_up(const TextureQuery& query, const std::array<Fraction, 2>& coordinates,
                      const Fraction& lambda);

}  // namespace edgecase::oracle
