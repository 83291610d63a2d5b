// SPDX-License-Identifier: MIT
//
// The level of detail: how many texels a pixel covers, as a logarithm.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "exact/interval.h"
#include "model/texture.h"
#include "rules/rule.h"

namespace edgecase {

// Essay: The logarithm
//
// Logarithms: how the level of detail is computed from the scale factor, lambda_base = log2(rho)
// (GL 4.6 core, 8.14.1).
//
// A logarithm is expensive, and a level of detail needs eight bits of it. Renderers therefore
// approximate it. The exponent of a floating-point number (1 + f) 2^e gives the integer part e. The
// logarithm of 1 + f remains, and renderers take it from a straight line or a table. The line may
// also be applied to a power of the number, and its result divided accordingly. That divides the
// error too:
//
//                                     largest error, levels
//     exact                            0
//     linear-mantissa                 -0.0861   e + f
//     linear-mantissa-of-square       -0.0431   half of that of the square: it needs no root
//     linear-mantissa-of-fourth-power -0.0216   a quarter of that of the fourth power
//     mantissa-8                      +-0.0029  e + log2(1 + f), f rounded to 1/256, half up
//
// All of them are exact at powers of two. The methods that use a power are also exact at the
// corresponding roots. Renderers compute these formulas in float32.

Rule log2_rule();  // texture.log2
// Of what coarse samplers look up.
inline constexpr int kRulingOnPrecision = 50;

// Ways to compute a logarithm, all of them monotonic.
enum class Log2Method {
  exact,
  linear_mantissa,
  linear_mantissa_of_square,
  linear_mantissa_of_fourth_power,
  mantissa_8,
};
template <>
inline constexpr auto kNames<Log2Method> = std::to_array<TabledAlternative<Log2Method>>(
    {{Log2Method::exact, "exact", Openness::open, "the logarithm itself"},
     {Log2Method::linear_mantissa, "linear-mantissa", Openness::illegal,
      "the exponent plus the mantissa minus 1: up to 0.0861 too small"},
     {Log2Method::linear_mantissa_of_square, "linear-mantissa-of-square", Openness::open,
      "half of linear-mantissa of the square: up to 0.0431 too small"},
     {Log2Method::linear_mantissa_of_fourth_power, "linear-mantissa-of-fourth-power",
      Openness::open, "a quarter of linear-mantissa of the fourth power: up to 0.0216 too small"},
     {Log2Method::mantissa_8, "mantissa-8", Openness::open,
      "the logarithm of the mantissa rounded to 8 bits: up to 0.0029 off"}});

// Bounds of a method's results for the numbers of 0 or more in an interval; minus infinity for 0.
// Powers of two are exact. A computed logarithm has bounds that are wider than the C library's log2
// by more than its error (rules/textures/directed.h). If nothing is known of the value, the result
// is everything.
Interval log2_of(Interval value, Log2Method method);

// Essay: Level of detail
//
// Level of detail: how much a texture shrinks at a fragment (GL 4.6 core, 8.14.1).
//
// Two vectors span the footprint of a pixel in the base level. They say how far the point in the
// texture moves from a pixel to the next along x and along y:
//
//     dx = (du/dx, dv/dx)      dy = (du/dy, dv/dy)      in texels of the base level
//
// The vectors span an ellipse. Ideally the scale factor rho is its major axis. Equation 8.11 takes
// the length of the longer vector. An implementation may take another function f. It must be
// continuous, must grow with the absolute value of each partial derivative, and must lie within one
// of the section's two bounds:
//
//     max(m_u, m_v) <= f <= m_u + m_v      m_u = max(|du/dx|, |du/dy|), m_v likewise
//     max(m_u, m_v) <= f <= sqrt(2) max(|du/dx| + |dv/dx|, |du/dy| + |dv/dy|)
//
// Neither upper bound contains the other. OpenGL ES has the second alone. In one dimension the
// derivatives of v are 0. Levels are selected by lambda, which follows from rho:
//
//     lambda_base = log2(rho), or what the shader gives in its place
//     lambda'     = lambda_base + bias      what textureQueryLod returns
//     lambda      = lambda' clamped to min_lod and max_lod
//
// Inputs are intervals, and results are bounds rounded outward. Exact numbers stay exact as long as
// results are doubles (rules/textures/directed.h). A footprint of 2^k by 0 therefore has the level
// k. If an input is not a number, the result is the interval of all possible values.

Rule scale_factor_rule();       // texture.scale-factor: its alternatives are ScaleFactor's
Rule level_derivatives_rule();  // texture.derivatives: alternatives as of derivative.plain
Rule lod_bias_rule();           // texture.lod-bias

enum class ScaleFactor {
  lengths,          // the longer of the two vectors: OpenGL's own
  largest_partial,  // max(m_u, m_v), the least that OpenGL allows
  sum_of_partials,  // m_u + m_v
  length_of_sum,    // |dx + dy|, not within the bounds
  length_of_both,   // sqrt(|dx|^2 + |dy|^2), at most the root of 2 times the longer one
  sum,              // |du/dx| + |dv/dx| + |du/dy| + |dv/dy|, not within the bounds
  x_only,           // |dx|: fixture GLideN64 2203
  y_only,           // |dy|
};
template <>
inline constexpr auto kNames<ScaleFactor> = std::to_array<TabledAlternative<ScaleFactor>>(
    {{ScaleFactor::lengths, "lengths", Openness::open,
      "the length of the longer vector of the pixel's footprint in the texture"},
     {ScaleFactor::largest_partial, "largest-partial", Openness::open,
      "the largest of the partial derivatives, which is the least value that is allowed"},
     {ScaleFactor::sum_of_partials, "sum-of-partials", Openness::open,
      "the larger partial derivative of u plus the larger one of v"},
     {ScaleFactor::length_of_sum, "length-of-sum", Openness::illegal,
      "the length of the sum of the two vectors, which is 0 where they are opposite"},
     {ScaleFactor::length_of_both, "length-of-both", Openness::open,
      "the root of the sum of all squares, up to half a level more than the longer vector"},
     {ScaleFactor::sum, "sum", Openness::illegal, "the sum of all four partial derivatives"},
     {ScaleFactor::x_only, "x-only", Openness::illegal,
      "the length of the vector along x, whatever happens along y"},
     {ScaleFactor::y_only, "y-only", Openness::illegal, "the length of the vector along y"}});

// The least GL_MAX_TEXTURE_LOD_BIAS that an implementation may have (table 23.54).
constexpr double kLeastBiasLimit = 2;
// The last level of the least GL_MAX_TEXTURE_SIZE, 16384: no level of detail is clamped below it.
constexpr double kLeastLevelLimit = 14;

// The limits that a renderer reports for its levels of detail.
struct LookupLimits {
  double bias = kLeastBiasLimit;  // its GL_MAX_TEXTURE_LOD_BIAS; that, or more
  bool is_es = false;             // OpenGL ES, which lacks one bound of the scale factor
  friend bool operator==(const LookupLimits&, const LookupLimits&) = default;
};

enum class BiasChoice {
  as_set,
  sampler_nearest_8,  // the sampler's bias is rounded to 1/256, half away from 0
  unclamped,          // the sum of the two biases is not clamped
  not_of_gradients,   // the sampler's bias is left out of textureGrad()
  half_a_level_more,
};
template <>
inline constexpr auto kNames<BiasChoice> = std::to_array<TabledAlternative<BiasChoice>>(
    {{BiasChoice::as_set, "as-set", Openness::open, "the sampler's bias plus the shader's"},
     {BiasChoice::sampler_nearest_8, "sampler-nearest-8", Openness::open,
      "the sampler's bias rounded to a multiple of 1/256, half away from 0, plus the shader's"},
     {BiasChoice::unclamped, "unclamped", Openness::open,
      "the sum of both, even beyond GL_MAX_TEXTURE_LOD_BIAS"},
     {BiasChoice::not_of_gradients, "not-of-gradients", Openness::illegal,
      "lookups with gradients leave the sampler's bias out"},
     {BiasChoice::half_a_level_more, "half-a-level-more", Openness::illegal,
      "the sum of both plus half a level"}});

// For u and v, or for s and t.
using IntervalPair = std::array<Interval, 2>;

struct Footprint {
  IntervalPair dx;  // du/dx and dv/dx; dv is ignored in one dimension
  IntervalPair dy;  // du/dy and dv/dy
  int dimensions = 2;
};

// Made from derivatives of (s, t) per pixel, by the size of the base level.
Footprint footprint(const IntervalPair& dx, const IntervalPair& dy, int width, int height,
                    int dimensions);

// The lengths of dx and of dy, texels per pixel.
IntervalPair lengths(const Footprint& footprint);

// The scale factor that a method makes of the footprint, texels per pixel, 0 or more.
Interval scale_factor(const Footprint& footprint, ScaleFactor method);
// The scale factors that any f may yield: from max(m_u, m_v) to the larger of the two upper bounds;
// for OpenGL ES to the second.
Interval permitted_scale_factor(const Footprint& footprint, const LookupLimits& limits = {});

// lambda': includes the sampler's bias, and the lookup's if it is of kind `bias`; their sum is
// clamped to kMaxLodBias. The sampler's also applies to a lod given by the shader, which takes the
// place of lambda_base.
Interval with_bias(Interval lambda_base, const Sampler& sampler, const Lookup& lookup,
                   BiasChoice choice);
// The permitted lambda'. If the sampler's bias, the lookup's or their sum is beyond the renderer's
// limit, either way, each may be clamped at any limit from there on, or not, and so may a result
// beyond kLeastLevelLimit: "Different implementations have chosen to perform clamping on
// intermediate and final terms … differently" (8.14.1).
Interval with_permitted_bias(Interval lambda_base, const Sampler& sampler, const Lookup& lookup,
                             const LookupLimits& limits = {});
// lambda: clamped to min_lod and max_lod.
Interval clamped(Interval lambda_prime, const Sampler& sampler);

}  // namespace edgecase
