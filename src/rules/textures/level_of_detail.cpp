// SPDX-License-Identifier: MIT
#include "rules/textures/level_of_detail.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/elementary.h"
#include "rules/textures/directed.h"
#include "rules/values/derivative.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// (1 + fraction) * 2^exponent, for finite numbers above 0; the fraction is 0 to 1 and a double.
struct Parts {
  int exponent;
  double fraction;
};

Parts parts_of(double value) {
  const int exponent = std::ilogb(value);
  return {exponent, std::scalbn(value, -exponent) - 1};
}

// The logarithm stays between the whole numbers on either side, whatever the error.
Interval exact_log2(double value) {
  const Parts parts = parts_of(value);
  if (parts.fraction == 0) return parts.exponent;
  const Interval bounds = around(binary_logarithm(value), kPlacesOfLibrary);
  return {std::max<double>(bounds.low, parts.exponent),
          std::min<double>(bounds.high, parts.exponent + 1)};
}

Interval linear_mantissa(double value) {
  const Parts parts = parts_of(value);
  return exact_sum(parts.exponent, parts.fraction);
}

// For 0 or more; numbers too small to be distinguished from 0 may have a square below it.
Interval square(Interval value) {
  return {Down::product(value.low, value.low), Up::product(value.high, value.high)};
}

// The sum with 1/2 is exact: a multiple of 2^-44 below 257.
Interval mantissa_8(double value) {
  const Parts parts = parts_of(value);
  const double steps = std::floor(parts.fraction * 256 + 0.5);
  return exact_sum(parts.exponent, exact_log2(1 + steps / 256));
}

Interval log2_of_point(double value, Log2Method method) {
  if (value <= 0) return -kInfinity;
  if (std::isinf(value)) return kInfinity;
  switch (method) {
    case Log2Method::exact:
      break;
    case Log2Method::linear_mantissa:
      return linear_mantissa(value);
    case Log2Method::linear_mantissa_of_square:
      return exact_product(log2_of(square(value), Log2Method::linear_mantissa), 0.5);
    case Log2Method::linear_mantissa_of_fourth_power:
      return exact_product(log2_of(square(square(value)), Log2Method::linear_mantissa), 0.25);
    case Log2Method::mantissa_8:
      return mantissa_8(value);
  }
  return exact_log2(value);
}

}  // namespace

Interval log2_of(Interval value, Log2Method method) {
  value = known(value);
  return {log2_of_point(value.low, method).low, log2_of_point(value.high, method).high};
}

Rule log2_rule() {
  Rule rule;
  rule.id = RuleId::texture_log2;
  rule.title = "The level of detail is the base-2 logarithm of the scale factor";
  rule.spec = "8.14.1, level of detail";
  rule.latitude =
      "the precision of samplers, which is not stated: 2^-6 of a level (rulings 20 and 50)";
  rule.standard = "exact";
  rule.alternatives = alternatives_of<Log2Method>();
  rule.rulings = {
      {20,
       "Logarithm: the level of detail is the base-2 logarithm of the scale factor (equation 8.7), "
       "and each operation is accurate to about 1 part in 10^5 (2.3.4.1). Samplers compute levels "
       "to a few bits, and OpenGL does not say to how many. The Khronos tests of filters "
       "(dEQP-GLES3.functional.texture.filtering.*) accept a level of detail that is off by 2^-6, "
       "with a warning one that is off by 2^-4, and none that is farther off. So a level of detail "
       "is permitted within 2^-6 of the logarithm of any scale factor that ruling 19 permits. One "
       "that is off by up to 2^-4 is contested by ruling 50; one farther off is a violation, "
       "whatever approximation leads there. The logarithm of 0 is reported as any number of -16 or "
       "less, which no bias leads out of magnification."},
      {kRulingOnPrecision,
       "Contested: a level of detail is off by 2^-6 to 2^-4, or a coordinate by 2^-7 to 2^-4 of a "
       "texel. 2.3.4.1 states 1 part in 10^5 of each operation. But no precision of samplers is "
       "stated, and OpenGL ES 3.2 says the same (2.3.4.1, 8.14.1, 8.14.2). The Khronos tests "
       "(dEQP-GLES3.functional.texture.filtering.*) ask for 6 bits of the level and 7 of "
       "coordinates, and let 4 and 4 pass with a warning about quality."}};
  return rule;
}

namespace {

// One end of the absolute value of each partial.
struct Partials {
  double ux, vx, uy, vy;
};

struct Range {
  Partials low, high;
};

// Partials in v of one dimension are 0.
Interval in_v(const Footprint& footprint, Interval partial) {
  return footprint.dimensions == 1 ? Interval(0) : known(partial);
}

Range range_of(const Footprint& f) {
  const Interval ux = magnitudes(known(f.dx[0]));
  const Interval vx = magnitudes(in_v(f, f.dx[1]));
  const Interval uy = magnitudes(known(f.dy[0]));
  const Interval vy = magnitudes(in_v(f, f.dy[1]));
  return {{ux.low, vx.low, uy.low, vy.low}, {ux.high, vx.high, uy.high, vy.high}};
}

// Rounded one way; every method except length_of_sum grows with each absolute value.
template <class Rounding>
double scale_factor_of(const Partials& p, ScaleFactor method) {
  const double along_x = root_of_squares<Rounding>({p.ux, p.vx});
  const double along_y = root_of_squares<Rounding>({p.uy, p.vy});
  const double u = std::max(p.ux, p.uy);
  const double v = std::max(p.vx, p.vy);
  switch (method) {
    case ScaleFactor::largest_partial:
      return std::max(u, v);
    case ScaleFactor::sum_of_partials:
      return Rounding::sum(u, v);
    case ScaleFactor::length_of_both:
      return root_of_squares<Rounding>({p.ux, p.vx, p.uy, p.vy});
    case ScaleFactor::sum:
      return Rounding::sum(Rounding::sum(p.ux, p.uy), Rounding::sum(p.vx, p.vy));
    case ScaleFactor::x_only:
      return along_x;
    case ScaleFactor::y_only:
      return along_y;
    case ScaleFactor::lengths:
    case ScaleFactor::length_of_sum:
      return std::max(along_x, along_y);
  }
  return along_x;
}

// For length_of_sum: the footprint that is left after its vectors have been added.
Footprint summed(const Footprint& f) {
  const Interval u = exact_sum(known(f.dx[0]), known(f.dy[0]));
  const Interval v = exact_sum(in_v(f, f.dx[1]), in_v(f, f.dy[1]));
  return {{u, v}, {0, 0}, f.dimensions};
}

Interval sampler_bias(const Sampler& sampler, const Lookup& lookup, BiasChoice choice) {
  const auto bias = static_cast<double>(sampler.lod_bias);
  if (choice == BiasChoice::not_of_gradients && lookup.kind == LookupKind::gradients) return 0;
  return known(choice == BiasChoice::sampler_nearest_8 ? std::round(bias * 256) / 256 : bias);
}

// A term that may be clamped at any limit of at least `least_limit`, or not at all.
Interval clamped_or_not(Interval term, double least_limit) {
  return hull(term, {std::clamp(term.low, -least_limit, least_limit),
                     std::clamp(term.high, -least_limit, least_limit)});
}

Interval shader_bias(const Lookup& lookup) {
  switch (lookup.kind) {
    case LookupKind::bias:
      return known(static_cast<double>(lookup.value));
    case LookupKind::implicit:
    case LookupKind::lod:
    case LookupKind::gradients:
      break;
  }
  return 0;
}

}  // namespace

Footprint footprint(const IntervalPair& dx, const IntervalPair& dy, int width, int height,
                    int dimensions) {
  const auto in_texels = [&](const IntervalPair& vector) {
    return IntervalPair{exact_product(known(vector[0]), width),
                        dimensions == 1 ? Interval(0) : exact_product(known(vector[1]), height)};
  };
  return {in_texels(dx), in_texels(dy), dimensions};
}

IntervalPair lengths(const Footprint& footprint) {
  return {scale_factor(footprint, ScaleFactor::x_only),
          scale_factor(footprint, ScaleFactor::y_only)};
}

Interval scale_factor(const Footprint& footprint, ScaleFactor method) {
  const bool sum = method == ScaleFactor::length_of_sum;
  const Range range = range_of(sum ? summed(footprint) : footprint);
  return {scale_factor_of<Down>(range.low, method), scale_factor_of<Up>(range.high, method)};
}

Interval permitted_scale_factor(const Footprint& footprint, const LookupLimits& limits) {
  constexpr double kRootOfTwo = 0x1.6a09e667f3bcdp0;  // rounded up
  const Partials high = range_of(footprint).high;
  const double larger_sum = std::max(Up::sum(high.ux, high.vx), Up::sum(high.uy, high.vy));
  const double of_ellipse = Up::product(kRootOfTwo, larger_sum);
  const double of_partials = scale_factor(footprint, ScaleFactor::sum_of_partials).high;
  return {scale_factor(footprint, ScaleFactor::largest_partial).low,
          limits.is_es ? of_ellipse : std::max(of_partials, of_ellipse)};
}

Interval with_bias(Interval lambda_base, const Sampler& sampler, const Lookup& lookup,
                   BiasChoice choice) {
  const Interval sum = known(exact_sum(sampler_bias(sampler, lookup, choice), shader_bias(lookup)));
  const Interval bias = choice == BiasChoice::unclamped
                            ? sum
                            : Interval(std::clamp(sum.low, -kMaxLodBias, kMaxLodBias),
                                       std::clamp(sum.high, -kMaxLodBias, kMaxLodBias));
  const Interval lambda_prime = known(exact_sum(known(lambda_base), bias));
  return choice == BiasChoice::half_a_level_more ? exact_sum(lambda_prime, 0.5) : lambda_prime;
}

Interval with_permitted_bias(Interval lambda_base, const Sampler& sampler, const Lookup& lookup,
                             const LookupLimits& limits) {
  const Interval of_sampler =
      clamped_or_not(sampler_bias(sampler, lookup, BiasChoice::as_set), limits.bias);
  const Interval of_shader = clamped_or_not(shader_bias(lookup), limits.bias);
  const Interval bias = clamped_or_not(known(exact_sum(of_sampler, of_shader)), limits.bias);
  return clamped_or_not(known(exact_sum(known(lambda_base), bias)), kLeastLevelLimit);
}

Interval clamped(Interval lambda_prime, const Sampler& sampler) {
  const auto clamp = [&](double lambda) {
    const double at_least = std::max(lambda, static_cast<double>(sampler.min_lod));
    return std::min(at_least, static_cast<double>(sampler.max_lod));
  };
  lambda_prime = known(lambda_prime);
  return {clamp(lambda_prime.low), clamp(lambda_prime.high)};
}

Rule scale_factor_rule() {
  Rule rule;
  rule.id = RuleId::texture_scale_factor;
  rule.title =
      "The scale factor is the length of the longer vector of a pixel's footprint in the texture";
  rule.spec = "8.14.1, scale factor and the conditions on its approximations";
  rule.latitude =
      "any function from the largest partial derivative to either upper bound of the section "
      "(ruling 19)";
  rule.standard = "lengths";
  rule.alternatives = alternatives_of<ScaleFactor>();
  rule.rulings = {
      {19,
       "Scale factor: permitted is any value from the largest absolute partial derivative to the "
       "larger of two bounds, which 8.14.1 states one after the other: m_u + m_v, where m_u is "
       "the larger absolute derivative of u along x and y and m_v that of v, and the root of 2 "
       "times the larger of |du/dx| + |dv/dx| and |du/dy| + |dv/dy|, which holds the major axis "
       "of the footprint's ellipse. Derivatives are those that ruling 16 permits for dFdx and "
       "dFdy, in texels of the base level. OpenGL ES has only the second bound, which applies to "
       "renderers that report OpenGL ES. A line's factor is its derivative along the line "
       "(8.12), which these bounds hold; exact takes that of polygons (8.11). That the function "
       "is one and the same for all fragments, and grows with each partial, is not judged of "
       "single fragments."}};
  return rule;
}

Rule level_derivatives_rule() {
  Rule rule = derivative_rule();
  rule.id = RuleId::texture_derivatives;
  rule.title = "The scale factor is computed from derivatives of the texture coordinates";
  rule.spec = "8.14.1, with GLSL 4.60, 8.14.1 (derivative functions)";
  rule.latitude = "the derivatives may be any that dFdx and dFdy may return (rulings 16 and 19)";
  rule.rulings.clear();
  return rule;
}

Rule lod_bias_rule() {
  Rule rule;
  rule.id = RuleId::texture_lod_bias;
  rule.title = "The bias of the sampler and that of the shader are added to the level of detail";
  rule.spec = "8.14.1, level of detail";
  rule.latitude =
      "the precision of the sampler's bias; which terms beyond GL_MAX_TEXTURE_LOD_BIAS, at least "
      "2, are clamped, and how (ruling 26); exact clamps the sum at 16";
  rule.standard = "as-set";
  rule.alternatives = alternatives_of<BiasChoice>();
  rule.rulings = {
      {26,
       "Bias: where the sampler's, the lookup's or the sum of both is beyond the "
       "GL_MAX_TEXTURE_LOD_BIAS that the renderer reports, or 2, the least, if it reports none, "
       "each of them may be clamped at any limit from there on, or not at all, and so may a "
       "level of detail beyond 14, the last level of the least GL_MAX_TEXTURE_SIZE: 8.14.1 says "
       "that implementations clamp intermediate and final terms differently and that results "
       "then differ. Elsewhere the sum is as it is. OpenGL does not say to how many bits a "
       "sampler keeps its bias: it may be off as the level of detail may (ruling 20)."}};
  return rule;
}

}  // namespace edgecase
