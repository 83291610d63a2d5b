// SPDX-License-Identifier: MIT
#include "diff/values/pixel_truth.h"

#include <cmath>
#include <vector>

#include "diff/values/value_judge.h"
#include "rules/values/inexact_shares.h"

namespace edgecase {

PixelTruth truth_of_clear(const Scene& scene) {
  PixelTruth truth;
  for (std::size_t c = 0; c < 4; ++c) {
    truth.exact[c] = static_cast<double>(scene.target.clear[c]);
    truth.permitted[c] = truth.exact[c];
  }
  return truth;
}

bool may_fade(const ValueContext& context, const Fragment& fragment) {
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  return primitive.kind == PrimitiveKind::point &&
         primitive.state->point_size < Fixed::from_integer(1) &&
         is_multisampled(*primitive.state, context.scene.target);
}

Interval with_fade(const ValueContext& context, const Fragment& fragment, Interval alpha) {
  if (!may_fade(context, fragment)) return alpha;
  const double size = context.primitive_of(fragment).state->point_size.to_double();
  return hull(alpha, widened(alpha * Interval(size * size), 3 * kInexact.relative));
}

PixelTruth truth_of_fragment(const ValueContext& context, const Fragment& fragment) {
  PixelTruth truth;
  if (fragment.has_color) {
    truth.exact = fragment.color;
    for (std::size_t c = 0; c < 4; ++c)
      truth.permitted[c] = std::isnan(truth.exact[c]) ? Interval::everything() : truth.exact[c];
    truth.permitted[3] = with_fade(context, fragment, truth.permitted[3]);
    return truth;
  }
  // What a texture would have shown is judged where it is told.
  if (context.primitive_of(fragment).state->texture) {
    truth.permitted.fill(Interval::everything());
    return truth;
  }
  const PrimitiveValues& values = context.values_of(fragment);
  const Point place = context.place_of(fragment, context.choices.values.locations);
  std::vector<PermittedPlace> corners;
  for (const Point corner : context.permitted_places(fragment))
    corners.emplace_back(values.moved(), corner);
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  const Point centre = pixel_centre(fragment.x, fragment.y);
  const PermittedPlace at_centre(values.moved(), centre);
  const Fixed column = height_of_column(primitive, context.scene.target);
  for (std::size_t c = 0; c < 4; ++c) {
    const Interpolant& lawful = values.lawful.color[c];
    Interval permitted = corners.empty()
                             ? at_centre.value(lawful)
                             : permitted_within(lawful, values.lawful.inverse_w, corners);
    if (column != Fixed())
      permitted = hull(permitted, permitted_across(lawful, values.moved(), at_centre, centre,
                                                   Fixed::from_raw(column.raw() / 2)));
    truth.exact[c] = middle(interpolate_exact(values.chosen.color[c], place));
    truth.permitted[c] = with_means(hull(permitted, truth.exact[c]), primitive, values, c);
  }
  truth.permitted[3] = with_fade(context, fragment, truth.permitted[3]);
  return truth;
}

}  // namespace edgecase
