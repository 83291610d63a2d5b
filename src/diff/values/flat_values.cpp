// SPDX-License-Identifier: MIT
#include "diff/values/flat_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "rules/all_rules.h"
#include "rules/values/flat_attribute.h"

namespace edgecase {
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

}  // namespace

void compare_flat_color(const ValueContext& context, const Fragment& fragment, Result& result) {
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  const Color color = flat_attribute(primitive, context.choices.values.provoking);
  const bool legal = shows(fragment, flat_attribute(primitive, ProvokingChoice::as_set));
  const bool agrees = shows(fragment, color);
  if (agrees && (legal || context.latitude == Latitude::none)) return;
  Disagreement d =
      value_disagreement({fragment.x, fragment.y}, fragment.primitive, RuleId::attribute_flat, 8);
  d.legality = by_letter(legal);
  d.policy_agrees = agrees;
  d.exact.assign(color.begin(), color.end());
  d.rendered.assign(fragment.color.begin(), fragment.color.end());
  d.cause = wrong_provoking_vertex(primitive, fragment);
  d.explanation = fmt::format(
      "the flat {} of primitive {} is that of its {} vertex, ({:.9g}), copied without "
      "computation; the renderer has ({:.9g}){}",
      primitive.state->texture ? "texture coordinate" : "colour", fragment.primitive,
      name_of(primitive.state->provoking_vertex), fmt::join(d.exact, ", "),
      fmt::join(d.rendered, ", "), d.cause.empty() ? "" : ", that of another vertex");
  result.disagreements.push_back(std::move(d));
}

}  // namespace edgecase
