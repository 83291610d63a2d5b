// SPDX-License-Identifier: MIT
//
// What rules/values/derivative.h says of both texture coordinates of a primitive. What they share
// is worked out once.
#pragma once

#include <array>

#include "rules/values/derivative.h"

namespace edgecase {

// Of s and t, which have the same vertices and line parameter and, with perspective, the same w.
std::array<Interval, 2> derivatives_exact(const Interpolant& s, const Interpolant& t,
                                          const QuadPixel& at, Axis axis, DerivativeMethod method);
std::array<Interval, 2> derivatives_inexact(const Interpolant& s, const Interpolant& t,
                                            const QuadPixel& at, Axis axis,
                                            DerivativeMethod method);

}  // namespace edgecase
