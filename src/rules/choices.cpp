// SPDX-License-Identifier: MIT
#include "rules/choices.h"

#include "rules/all_rules.h"

namespace edgecase {
namespace {

// The alternative that a policy chooses for a rule on a surface; empty if it chooses none.
std::string chosen(const Policy& policy, Surface surface, const std::string& rule) {
  if (const auto overrides = policy.surfaces.find(surface); overrides != policy.surfaces.end())
    if (const auto choice = overrides->second.find(rule); choice != overrides->second.end())
      return choice->second;
  const auto choice = policy.rules.find(rule);
  return choice != policy.rules.end() ? choice->second : "";
}

}  // namespace

const CoverageChoice& RuleChoices::of(PrimitiveKind kind) const {
  switch (kind) {
    case PrimitiveKind::point:
      return points;
    case PrimitiveKind::line:
      return lines;
    case PrimitiveKind::triangle:
      return triangles;
  }
  return triangles;
}

RuleId coverage_rule_of(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::point:
      return RuleId::point_ownership;
    case PrimitiveKind::line:
      return RuleId::line_diamond_exit;
    case PrimitiveKind::triangle:
      return RuleId::triangle_fill_rule;
  }
  return RuleId::none;
}

RuleId snap_rule_of(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::point:
      return RuleId::point_snap;
    case PrimitiveKind::line:
      return RuleId::line_snap;
    case PrimitiveKind::triangle:
      return RuleId::triangle_snap;
  }
  return RuleId::none;
}

RuleId row_order_rule_of(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::point:
      return RuleId::point_row_order;
    case PrimitiveKind::line:
      return RuleId::line_row_order;
    case PrimitiveKind::triangle:
      return RuleId::triangle_row_order;
  }
  return RuleId::none;
}

RuleChoices resolve(const Policy& policy, Surface surface) {
  RuleChoices choices;
  for (const Rule& rule : all_rules()) {
    if (rule.slot.put == nullptr) continue;
    const std::string choice = chosen(policy, surface, name_of(rule.id));
    if (!choice.empty())
      rule.slot.put(choices, choice);
    else if (!rule.slot.stays)
      rule.slot.put(choices, rule.standard);
  }
  return choices;
}

const RuleChoices& standard_choices() {
  static const RuleChoices choices = resolve(Policy{}, Surface::fbo);
  return choices;
}

ResolvedPolicy::ResolvedPolicy(const Policy& policy)
    : latitude_(policy.latitude), is_standard_(policy.rules.empty() && policy.surfaces.empty()) {
  for (const Surface surface : values_of<Surface>())
    choices_[static_cast<std::size_t>(surface)] = resolve(policy, surface);
}

}  // namespace edgecase
