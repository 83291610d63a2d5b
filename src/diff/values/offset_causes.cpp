// SPDX-License-Identifier: MIT
#include "diff/values/offset_causes.h"

#include <algorithm>
#include <map>

#include "rules/all_rules.h"
#include "rules/changes.h"

namespace edgecase {
namespace {

Changes unit_changes(const RuleChoices& chosen, DepthFormat format) {
  return changes_beside(
      format == DepthFormat::depth32f ? RuleId::offset_exponent : RuleId::offset_unit, chosen);
}

// Every alternative beside what is chosen, and then every slope with every unit.
std::vector<Changes> offset_changes(const RuleChoices& chosen, DepthFormat format) {
  const Changes slopes = changes_beside(RuleId::offset_slope, chosen);
  const Changes units = unit_changes(chosen, format);
  std::vector<Changes> sets;
  for (const Changes& singles : {slopes, units})
    for (const Change& change : singles) sets.push_back({change});
  for (const Change& slope : slopes)
    for (const Change& unit : units) sets.push_back({slope, unit});
  return sets;
}

PrimitiveAttributes attributes_under(const ValueContext& context, const Fragment& fragment,
                                     const Changes& changes) {
  return attributes_of(context.primitive_of(fragment), applied(changes, context.choices),
                       context.scene.target);
}

Point plain_place_of(const ValueContext& context, const Fragment& fragment) {
  return context.depth_place_of(fragment, context.choices.values.locations);
}

bool is_exact(const ValueContext& context, const Fragment& fragment,
              const PrimitiveAttributes& attributes) {
  return to_float(middle(depth_exact(attributes, plain_place_of(context, fragment)))) ==
         to_float(fragment.depth);
}

bool is_inexact(const ValueContext& context, const Fragment& fragment,
                const PrimitiveAttributes& attributes) {
  const Interval depth = interpolate_inexact(attributes.depth, plain_place_of(context, fragment));
  return rounded_to_float(clamped_depth(attributes, depth)).contains(to_float(fragment.depth));
}

using Test = bool (*)(const ValueContext&, const Fragment&, const PrimitiveAttributes&);

// Do all fragments with an offset pass the test with these changes?
bool all_pass(const ValueContext& context, const Rendering& rendered, const Changes& changes,
              Test test) {
  std::map<int, PrimitiveAttributes> attributes;
  return std::ranges::all_of(rendered.fragments, [&](const Fragment& fragment) {
    if (!fragment.has_depth || !has_offset(context, fragment)) return true;
    auto known = attributes.find(fragment.primitive);
    if (known == attributes.end())
      known = attributes.emplace(fragment.primitive, attributes_under(context, fragment, changes))
                  .first;
    return test(context, fragment, known->second);
  });
}

}  // namespace

bool has_offset(const ValueContext& context, const Fragment& fragment) {
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  return primitive.kind == PrimitiveKind::triangle && primitive.state->polygon_offset;
}

RuleId offset_rule(const ValueContext& context, const Fragment& fragment) {
  if (context.primitive_of(fragment).state->polygon_offset->factor != 0)
    return RuleId::offset_slope;
  return context.scene.target.depth == DepthFormat::depth32f ? RuleId::offset_exponent
                                                             : RuleId::offset_unit;
}

Cause cause_of_offset(const ValueContext& context, const Fragment& fragment) {
  for (const Changes& changes : offset_changes(context.choices, context.scene.target.depth))
    if (is_inexact(context, fragment, attributes_under(context, fragment, changes)))
      return cause_of(changes);
  return {};
}

FollowedOffset followed_offset(const ValueContext& context, const Rendering& rendered) {
  // Most scenes have none: then no fragment need be asked.
  if (std::ranges::none_of(context.scene.draws,
                           [](const Draw& draw) { return draw.polygon_offset.has_value(); }))
    return {};
  const auto concerned = [&](const Fragment& f) { return f.has_depth && has_offset(context, f); };
  if (std::ranges::none_of(rendered.fragments, concerned)) return {};
  // The alternative that yields every depth to the bit, else one that inexact operations yield.
  for (const Test test : {&is_exact, &is_inexact}) {
    if (all_pass(context, rendered, {}, test)) return {};
    for (const Changes& changes : offset_changes(context.choices, context.scene.target.depth))
      if (all_pass(context, rendered, changes, test)) {
        const RuleId rule = changes.front().id.rule;
        return {cause_of(changes), rule, rule_of(rule).ruling};
      }
  }
  return {};
}

}  // namespace edgecase
