// SPDX-License-Identifier: MIT
#include "diff/values/flat_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "diff/findings/add_disagreement.h"
#include "raster/samples.h"
#include "rules/all_rules.h"
#include "rules/values/attributes.h"

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

namespace {

bool shows(const Fragment& fragment, const Color& color) {
  return std::equal(color.begin(), color.end(), fragment.color.begin(),
                    [](float a, double b) { return a == static_cast<float>(b); });
}

Color flat_attribute(const ScenePrimitive& primitive, ProvokingChoice choice) {
  return interpolated_attribute(*primitive.state,
                                *primitive.vertices[provoking_index(primitive, choice)]);
}

// The vertex whose colour a flat fragment shows against the scene's convention, as a cause.
Cause wrong_provoking_vertex(const ScenePrimitive& primitive, const Fragment& fragment) {
  for (const ProvokingChoice choice : {ProvokingChoice::first, ProvokingChoice::last})
    if (shows(fragment, flat_attribute(primitive, choice)))
      return alternative_id(RuleId::attribute_provoking_vertex, name_of(choice));
  return {};
}

// True if OpenGL ES may have interpolated a flat colour.
bool is_permitted_flat(const ValueContext& context, const Fragment& fragment, const Color& color) {
  for (std::size_t c = 0; c < color.size(); ++c)
    if (!permitted_flat(context, context.primitive_of(fragment), static_cast<double>(color[c]))
             .contains(fragment.color[c]))
      return false;
  return true;
}

}  // namespace

bool compare_flat_color(const ValueContext& context, const Fragment& fragment, Result& result) {
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  const Color color = flat_attribute(primitive, context.choices.values.provoking);
  const Color lawful = flat_attribute(primitive, ProvokingChoice::as_set);
  const bool is_copied = shows(fragment, lawful);
  const bool legal = is_copied || is_permitted_flat(context, fragment, lawful);
  const bool agrees = shows(fragment, color);
  if (agrees && (legal || context.latitude == Latitude::none)) return true;
  Disagreement d =
      value_disagreement({fragment.x, fragment.y}, fragment.primitive, RuleId::attribute_flat);
  d.legality = by_letter(legal);
  d.policy_agrees = agrees;
  d.exact.assign(color.begin(), color.end());
  d.rendered.assign(fragment.color.begin(), fragment.color.end());
  d.cause = wrong_provoking_vertex(primitive, fragment);
  d.explanation = fmt::format(
      "the flat {} of primitive {} is that of its {} vertex, ({:.9g}), copied without "
      "computation; the renderer has ({:.9g}){}{}",
      primitive.state->texture ? "texture coordinate" : "colour", fragment.primitive,
      name_of(primitive.state->provoking_vertex), fmt::join(d.exact, ", "),
      fmt::join(d.rendered, ", "), d.cause.empty() ? "" : ", that of another vertex",
      legal && !is_copied ? "; OpenGL ES interpolates, and precision may be lost" : "");
  add_disagreement(result, std::move(d));
  return false;
}

bool may_go_by_major_axis(const ValueContext& context, const Fragment& fragment) {
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  return context.lookup_limits().is_es && primitive.kind == PrimitiveKind::line &&
         !is_multisampled(*primitive.state, context.scene.target);
}

}  // namespace edgecase
