// SPDX-License-Identifier: MIT
#include "diff/values/coordinate_places.h"

#include <cmath>

#include "raster/attributes.h"
#include "rules/values/permitted_interpolation.h"

namespace edgecase {

bool is_at_share_of_one(const ValueContext& context, const Fragment& fragment) {
  const Multisampling& use = context.primitive_of(fragment).state->multisampling;
  return context.scene.target.samples > 1 && fragment.coverage != 0 && use.enabled &&
         use.min_sample_shading == 1.0F;
}

std::optional<Point> other_place(const ValueContext& context, const Rendering& rendered,
                                 const Fragment& fragment) {
  if (!is_at_share_of_one(context, fragment) || fragment.detail < 0) return std::nullopt;
  const auto& coordinates = rendered.details[static_cast<std::size_t>(fragment.detail)].coordinates;
  if (!coordinates) return std::nullopt;
  const double x = (*coordinates)[0];
  const double y = (*coordinates)[1];
  const bool inside =
      x >= fragment.x && x <= fragment.x + 1 && y >= fragment.y && y <= fragment.y + 1;
  const Point sample = context.coordinates_of(fragment);
  if (!inside || (x == sample.x.to_double() && y == sample.y.to_double())) return std::nullopt;
  const auto fixed = [](double n) {
    return Fixed::from_raw(std::llround(n * static_cast<double>(Fixed::kOne)));
  };
  return Point{fixed(x), fixed(y)};
}

bool has_depth_of(const ValueContext& context, const Fragment& fragment, Point place) {
  const PrimitiveValues& values = context.values_of(fragment);
  const Interval depth = PermittedPlace(values.moved(), place).value(values.permitted_depth);
  return rounded_to_float(clamped_depth(values.lawful, depth)).contains(to_float(fragment.depth));
}

// 1/w is linear over the pixel, so its corners have the least and the largest.
bool has_w_of_pixel(const ValueContext& context, const Fragment& fragment, double inverse_w) {
  const PrimitiveValues& values = context.values_of(fragment);
  std::optional<Interval> permitted;
  for (const int corner : {0, 1, 2, 3}) {
    const Point place{Fixed::from_integer(fragment.x + corner % 2),
                      Fixed::from_integer(fragment.y + corner / 2)};
    const Interval here = PermittedPlace(values.moved(), place).value(values.permitted_inverse_w);
    permitted = permitted ? hull(*permitted, here) : here;
  }
  return rounded_to_float(*permitted).contains(to_float(inverse_w));
}

}  // namespace edgecase
