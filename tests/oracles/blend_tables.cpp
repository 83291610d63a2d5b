// SPDX-License-Identifier: MIT
#include "tests/oracles/blend_tables.h"

namespace edgecase::oracle {
namespace {

const Fraction kHalf(1, 2);

Fraction clamped(const Fraction& value) {
  if (value < 0) return 0;
  return value > 1 ? Fraction(1) : value;
}

// An entry of table 17.2: a factor's red, green or blue, or its alpha.
Fraction factor_of(BlendFactor factor, const FractionColor& s, const FractionColor& d,
                   const FractionColor& c, std::size_t i) {
  switch (factor) {
    case BlendFactor::zero:
      return 0;
    case BlendFactor::one:
      return 1;
    case BlendFactor::src_color:
      return s[i];
    case BlendFactor::one_minus_src_color:
      return 1 - s[i];
    case BlendFactor::dst_color:
      return d[i];
    case BlendFactor::one_minus_dst_color:
      return 1 - d[i];
    case BlendFactor::src_alpha:
      return s[3];
    case BlendFactor::one_minus_src_alpha:
      return 1 - s[3];
    case BlendFactor::dst_alpha:
      return d[3];
    case BlendFactor::one_minus_dst_alpha:
      return 1 - d[3];
    case BlendFactor::constant_color:
      return c[i];
    case BlendFactor::one_minus_constant_color:
      return 1 - c[i];
    case BlendFactor::constant_alpha:
      return c[3];
    case BlendFactor::one_minus_constant_alpha:
      return 1 - c[3];
    case BlendFactor::src_alpha_saturate: {
      if (i == 3) return 1;
      const Fraction rest = 1 - d[3];
      return s[3] < rest ? s[3] : rest;
    }
  }
  return 0;
}

// A row of table 17.1.
Fraction by_term(const BlendTerm& term, const FractionColor& s, const FractionColor& d,
                 const FractionColor& c, RoundedSteps steps, std::size_t i) {
  if (term.equation == BlendEquation::min) return s[i] < d[i] ? s[i] : d[i];
  if (term.equation == BlendEquation::max) return s[i] < d[i] ? d[i] : s[i];
  Fraction source = s[i] * factor_of(term.source, s, d, c, i);
  Fraction destination = d[i] * factor_of(term.destination, s, d, c, i);
  if (steps.products) {
    source = Fraction(nearest_code(source), 255);
    destination = Fraction(nearest_code(destination), 255);
  }
  if (term.equation == BlendEquation::subtract) return clamped(source - destination);
  if (term.equation == BlendEquation::reverse_subtract) return clamped(destination - source);
  return clamped(source + destination);
}

}  // namespace

int nearest_code(const Fraction& value) {
  const Fraction scaled = 255 * clamped(value);
  const auto below =
      static_cast<int>(boost::multiprecision::cpp_int(numerator(scaled) / denominator(scaled)));
  const Fraction rest = scaled - below;
  if (rest == kHalf) return below + below % 2;
  return rest > kHalf ? below + 1 : below;
}

FractionColor blended_colors(const Blending& blending, FractionColor source,
                             const FractionColor& destination, RoundedSteps steps) {
  FractionColor constant;
  for (std::size_t i = 0; i < 4; ++i) constant[i] = Fraction(blending.constant[i]);
  for (FractionColor* color : {&source, &constant})
    for (Fraction& value : *color)
      value = steps.operands ? Fraction(nearest_code(value), 255) : clamped(value);
  FractionColor result;
  for (std::size_t i = 0; i < 4; ++i)
    result[i] =
        by_term(i == 3 ? blending.alpha : blending.color, source, destination, constant, steps, i);
  return result;
}

}  // namespace edgecase::oracle
