// SPDX-License-Identifier: MIT
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
#pragma once

#include <span>
#include <string_view>

#include "exact/interval.h"
#include "rules/rule.h"

namespace edgecase {

Rule log2_rule();  // texture.log2

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

}  // namespace edgecase
