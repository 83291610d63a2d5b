// SPDX-License-Identifier: MIT
#include "rules/choices.h"

#include "rules/all_rules.h"

namespace edgecase {
namespace {

// The alternative that a policy chooses for a rule on a surface; empty where it chooses none.
std::string chosen(const Policy& policy, Surface surface, const std::string& rule) {
  if (const auto overrides = policy.surfaces.find(surface); overrides != policy.surfaces.end())
    if (const auto choice = overrides->second.find(rule); choice != overrides->second.end())
      return choice->second;
  const auto choice = policy.rules.find(rule);
  return choice != policy.rules.end() ? choice->second : "";
}

CoverageChoice resolve_primitive(const Policy& policy, Surface surface, Primitive primitive) {
  CoverageChoice result;
  std::string snap = chosen(policy, surface, snap_rule_of(primitive));
  if (snap.empty()) snap = chosen(policy, surface, "subpixel.snap");
  if (const Snap* found = find_snap(snap)) result.snap = *found;
  std::string ties = chosen(policy, surface, coverage_rule_of(primitive));
  if (ties.empty()) ties = find_rule(coverage_rule_of(primitive))->standard;
  result.ties = *find_tie_rule(ties);
  return result;
}

ValueChoice resolve_values(const Policy& policy, Surface surface) {
  ValueChoice result;
  const std::string provoking = chosen(policy, surface, "attribute.provoking-vertex");
  if (provoking == "first") result.provoking = ProvokingChoice::first;
  if (provoking == "last") result.provoking = ProvokingChoice::last;
  if (chosen(policy, surface, "attribute.smooth") == "major-axis")
    result.line_parameter = LineParameter::major_axis;
  return result;
}

}  // namespace

const CoverageChoice& RuleChoices::of(Primitive primitive) const {
  switch (primitive) {
    case Primitive::points:
      return points;
    case Primitive::lines:
      return lines;
    case Primitive::triangles:
      return triangles;
  }
  return triangles;
}

const char* coverage_rule_of(Primitive primitive) {
  switch (primitive) {
    case Primitive::points:
      return "point.ownership";
    case Primitive::lines:
      return "line.diamond-exit";
    case Primitive::triangles:
      return "triangle.fill-rule";
  }
  return "?";
}

const char* snap_rule_of(Primitive primitive) {
  switch (primitive) {
    case Primitive::points:
      return "point.snap";
    case Primitive::lines:
      return "line.snap";
    case Primitive::triangles:
      return "triangle.snap";
  }
  return "?";
}

RuleChoices resolve(const Policy& policy, Surface surface) {
  return {resolve_primitive(policy, surface, Primitive::points),
          resolve_primitive(policy, surface, Primitive::lines),
          resolve_primitive(policy, surface, Primitive::triangles),
          resolve_values(policy, surface)};
}

}  // namespace edgecase
