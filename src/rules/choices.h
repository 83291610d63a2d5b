// SPDX-License-Identifier: MIT
//
// Choices: a policy looked up once, so that predicates get values and not names.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/policy.h"
#include "rules/coverage/snap.h"
#include "rules/coverage/tie_rule.h"
#include "rules/values/flat_attribute.h"
#include "rules/values/smooth_attribute.h"

namespace edgecase {

// What a policy says for one primitive type.
struct CoverageChoice {
  Snap snap;
  TieRule ties;
};

// What a policy says of attributes.
struct ValueChoice {
  ProvokingChoice provoking = ProvokingChoice::as_set;
  LineParameter line_parameter = LineParameter::projection;
};

// What a policy says for one surface.
struct RuleChoices {
  CoverageChoice points;
  CoverageChoice lines;
  CoverageChoice triangles;
  ValueChoice values;

  const CoverageChoice& of(Primitive primitive) const;
};

// Rules and alternatives that the policy names must be of the catalogue.
RuleChoices resolve(const Policy& policy, Surface surface);

// The rule that decides the coverage of a primitive type, and the rule of its snapping.
const char* coverage_rule_of(Primitive primitive);
const char* snap_rule_of(Primitive primitive);

}  // namespace edgecase
