// SPDX-License-Identifier: MIT
//
// Where else a renderer evaluates the attributes of multisampled draws: the choice that the
// specification leaves open, read off all fragments of a case together.
#pragma once

#include "diff/values/value_diff.h"
#include "rules/changes.h"

namespace edgecase {

// Every alternative of where attributes but depth are evaluated, beside what is chosen.
Changes location_changes(const RuleChoices& chosen);

// Where they and depths are evaluated under a change.
LocationChoice locations_of(const Change& change, const RuleChoices& chosen);

// What all smooth colours of a case are evaluated by, where the policy's own choice does not yield
// them; without a cause where there is no such thing.
struct FollowedLocation {
  Cause cause;
  RuleId rule = RuleId::attribute_smooth;
  int ruling = 9;

  // Is the fragment's colour another than the policy's place yields, and has it so?
  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedLocation followed_location(const ValueContext& context, const Rendering& rendered);

// The same of gl_FragCoord.z.
struct FollowedDepth {
  Cause cause;
  RuleId rule = RuleId::fragment_depth;
  int ruling = 9;

  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedDepth followed_depth(const ValueContext& context, const Rendering& rendered);

// Does a primitive with this depth have gl_FragCoord.z so where a choice evaluates it?
bool yields_depth(const ValueContext& context, const Fragment& fragment, const Interpolant& depth,
                  const LocationChoice& choice);

}  // namespace edgecase
