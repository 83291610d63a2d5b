// SPDX-License-Identifier: MIT
//
// Blending as the specification's tables write it (GL 4.6 core, 17.3.6, tables 17.1 and 17.2), in
// fractions without a bound on their size: a whole colour at a time, nothing rounded but where
// asked.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>

#include "model/fragment_operations.h"

namespace edgecase::oracle {

using Fraction = boost::multiprecision::cpp_rational;
using FractionColor = std::array<Fraction, 4>;  // red, green, blue, alpha

// Where a computation is rounded to the nearest multiple of 1/255 on its way.
struct RoundedSteps {
  bool operands = false;  // source and constant
  bool products = false;
};

// The nearest of 0 to 255 to 255 times a number, a tie to the even one.
int nearest_code(const Fraction& value);

// Both colours by the draw's equations, every number clamped to 0 to 1 first, and the result too.
FractionColor blended_colors(const Blending& blending, FractionColor source,
                             const FractionColor& destination, RoundedSteps steps);

}  // namespace edgecase::oracle
