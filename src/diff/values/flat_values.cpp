// SPDX-License-Identifier: MIT
#include "diff/values/flat_values.h"

#include <cmath>

#include "raster/samples.h"

namespace edgecase {

// Equation 13.7 with three equal values. Its shares have one sign inside the polygon, so a sum errs
// by no larger a part than its terms do. The numerator has a product, a division by w and two sums,
// the denominator a division and two sums, and one is divided by the other: eight operations, each
// with an error of 1 part in 10^5. Ten parts hold their products, too.
Interval permitted_flat(const ValueContext& context, const ScenePrimitive& primitive,
                        double value) {
  constexpr double kPart = 1e-4;
  const bool is_interpolated =
      context.lookup_limits().is_es && primitive.kind == PrimitiveKind::triangle;
  if (!is_interpolated || !std::isfinite(value)) return value;
  const double most = std::fabs(value) * kPart;
  return {value - most, value + most};
}

bool may_go_by_major_axis(const ValueContext& context, const Fragment& fragment) {
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  return context.lookup_limits().is_es && primitive.kind == PrimitiveKind::line &&
         !is_multisampled(*primitive.state, context.scene.target);
}

}  // namespace edgecase
