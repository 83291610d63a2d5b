// SPDX-License-Identifier: MIT
#include "rules/values/coordinate_derivatives.h"

#include "rules/values/exact_place.h"
#include "rules/values/inexact_place.h"

namespace edgecase {
namespace {

Point centre_of(PixelPosition pixel) {
  return pixel_centre(pixel.x, pixel.y);
}

}  // namespace

std::array<Interval, 2> derivatives_exact(const Interpolant& s, const Interpolant& t,
                                          const QuadPixel& at, Axis axis, DerivativeMethod method) {
  if (method == DerivativeMethod::analytic || is_constant(s) || is_constant(t))
    return {derivative_exact(s, at, axis, method), derivative_exact(t, at, axis, method)};
  const Neighbours of = neighbours_of(at, axis, method);
  const ExactPlace first(centre_of(of.first)), second(centre_of(of.second));
  return {second.value(s) - first.value(s), second.value(t) - first.value(t)};
}

std::array<Interval, 2> derivatives_inexact(const Interpolant& s, const Interpolant& t,
                                            const QuadPixel& at, Axis axis,
                                            DerivativeMethod method) {
  if (method == DerivativeMethod::analytic)
    return {derivative_inexact(s, at, axis, method), derivative_inexact(t, at, axis, method)};
  const Neighbours of = neighbours_of(at, axis, method);
  const InexactPlace first(centre_of(of.first)), second(centre_of(of.second));
  return {kInexact.subtract(second.value(s), first.value(s)),
          kInexact.subtract(second.value(t), first.value(t))};
}

}  // namespace edgecase
