// SPDX-License-Identifier: MIT
#include "diff/values/pixel_truth.h"

#include <cmath>

#include "diff/values/value_diff.h"
#include "diff/values/value_judge.h"
#include "rules/coverage/clip_volume.h"
#include "rules/values/permitted_interpolation.h"

namespace edgecase {

PixelTruth truth_of_clear(const Scene& scene) {
  PixelTruth truth;
  for (std::size_t c = 0; c < 4; ++c) {
    truth.exact[c] = static_cast<double>(scene.target.clear[c]);
    truth.permitted[c] = truth.exact[c];
  }
  return truth;
}

Interval accepted(const PixelTruth& truth, std::size_t component) {
  Interval all = truth.permitted[component];
  for (const PixelTruth::Contested& more : truth.contested) all = hull(all, more.bounds[component]);
  return all;
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
  if (context.is_open_stray(fragment)) {
    truth.permitted.fill(Interval::everything());
    return truth;
  }
  if (context.primitive_of(fragment).state->texture) {
    truth = context.looked_up(fragment);
    truth.permitted[3] = with_fade(context, fragment, truth.permitted[3]);
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
    truth.permitted[c] = hull(permitted, truth.exact[c]);
  }
  if (values.is_polygon) {
    PixelTruth::Contested means{RuleId::clip_volume, kRulingOnPolygonValues};
    for (std::size_t c = 0; c < 4; ++c)
      means.bounds[c] = with_means(truth.permitted[c], primitive, values, values.lawful.color[c]);
    truth.contested.push_back(means);
  }
  truth.permitted[3] = with_fade(context, fragment, truth.permitted[3]);
  return truth;
}

bool has_flat_color(const ValueContext& context, const Fragment& fragment) {
  const Draw& state = *context.primitive_of(fragment).state;
  return state.interpolation == Interpolation::flat && !state.texture;
}

}  // namespace edgecase
