// SPDX-License-Identifier: MIT
#include "diff/values/offset_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace edgecase {
namespace {

struct OffsetChange {
  std::string cause;
  OffsetChoice choice;
};

template <class Choice>
void add_beside(const OffsetChange& base, const char* rule, std::span<const Choice> all,
                Choice OffsetChoice::*part, std::vector<OffsetChange>& changes) {
  for (const Choice choice : all) {
    if (choice == base.choice.*part) continue;
    OffsetChange change = base;
    if (!change.cause.empty()) change.cause += " + ";
    change.cause += fmt::format("{}={}", rule, name_of(choice));
    change.choice.*part = choice;
    changes.push_back(std::move(change));
  }
}

void add_units_beside(const OffsetChange& base, DepthFormat format,
                      std::vector<OffsetChange>& changes) {
  if (format == DepthFormat::depth32f)
    add_beside(base, "offset.exponent", values_of<OffsetExponent>(), &OffsetChoice::exponent,
               changes);
  else
    add_beside(base, "offset.unit", values_of<OffsetUnit>(), &OffsetChoice::unit, changes);
}

// Every alternative beside what is chosen, and then every slope with every unit.
std::vector<OffsetChange> offsets_beside(const OffsetChoice& chosen, DepthFormat format) {
  std::vector<OffsetChange> slopes;
  add_beside({"", chosen}, "offset.slope", values_of<OffsetSlope>(), &OffsetChoice::slope, slopes);
  std::vector<OffsetChange> changes = slopes;
  add_units_beside({"", chosen}, format, changes);
  for (const OffsetChange& slope : slopes) add_units_beside(slope, format, changes);
  return changes;
}

PrimitiveAttributes attributes_under(const ValueContext& context, const Fragment& fragment,
                                     const OffsetChoice& offset) {
  RuleChoices choices = context.choices;
  choices.values.offset = offset;
  return attributes_of(context.primitive_of(fragment), choices, context.scene.target);
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

// Do all fragments with an offset pass the test under a choice?
bool all_pass(const ValueContext& context, const Rendering& rendered, const OffsetChoice& offset,
              Test test) {
  std::map<int, PrimitiveAttributes> attributes;
  return std::ranges::all_of(rendered.fragments, [&](const Fragment& fragment) {
    if (!fragment.has_depth || !has_offset(context, fragment)) return true;
    auto known = attributes.find(fragment.primitive);
    if (known == attributes.end())
      known =
          attributes.emplace(fragment.primitive, attributes_under(context, fragment, offset)).first;
    return test(context, fragment, known->second);
  });
}

}  // namespace

bool has_offset(const ValueContext& context, const Fragment& fragment) {
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  return primitive.kind == PrimitiveKind::triangle && primitive.state->polygon_offset;
}

const char* offset_rule(const ValueContext& context, const Fragment& fragment) {
  if (context.primitive_of(fragment).state->polygon_offset->factor != 0) return "offset.slope";
  return context.scene.target.depth == DepthFormat::depth32f ? "offset.exponent" : "offset.unit";
}

std::string cause_of_offset(const ValueContext& context, const Fragment& fragment) {
  for (const OffsetChange& change :
       offsets_beside(context.choices.values.offset, context.scene.target.depth))
    if (is_inexact(context, fragment, attributes_under(context, fragment, change.choice)))
      return change.cause;
  return "";
}

FollowedOffset followed_offset(const ValueContext& context, const Rendering& rendered) {
  // Most scenes have none: then no fragment need be asked.
  if (std::ranges::none_of(context.scene.draws,
                           [](const Draw& draw) { return draw.polygon_offset.has_value(); }))
    return {};
  const auto concerned = [&](const Fragment& f) { return f.has_depth && has_offset(context, f); };
  if (std::ranges::none_of(rendered.fragments, concerned)) return {};
  const OffsetChoice& chosen = context.choices.values.offset;
  // The alternative that yields every depth to the bit, else one that inexact operations yield.
  for (const Test test : {&is_exact, &is_inexact}) {
    if (all_pass(context, rendered, chosen, test)) return {};
    for (const OffsetChange& change : offsets_beside(chosen, context.scene.target.depth))
      if (all_pass(context, rendered, change.choice, test))
        return {change.cause, change.cause.substr(0, change.cause.find('=')), 38};
  }
  return {};
}

}  // namespace edgecase
