// SPDX-License-Identifier: MIT
//
// Other locations at which a renderer evaluates the attributes of multisampled draws: the choice
// that the specification leaves open, found from all fragments of a case together.
#pragma once

#include "diff/values/value_diff.h"
#include "rules/values/attributes.h"

namespace edgecase {

// The location at which all smooth colours of a case are evaluated, if the policy's own choice does
// not yield them; without a cause if there is none.
struct FollowedLocation {
  Cause cause;
  RuleId rule = RuleId::attribute_smooth;
  int ruling = kRulingOnInterpolation;

  // True if this location yields the fragment's colour and the policy's does not.
  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedLocation followed_location(const ValueContext& context, const Rendering& rendered);

// The same for gl_FragCoord.z.
struct FollowedDepth {
  Cause cause;
  RuleId rule = RuleId::fragment_depth;
  int ruling = kRulingOnInterpolation;

  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedDepth followed_depth(const ValueContext& context, const Rendering& rendered);

}  // namespace edgecase
