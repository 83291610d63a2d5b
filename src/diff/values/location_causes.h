// SPDX-License-Identifier: MIT
//
// Where else a renderer evaluates the attributes of multisampled draws: the choice that the
// specification leaves open, read off all fragments of a case together.
#pragma once

#include <string>
#include <vector>

#include "diff/values/value_diff.h"

namespace edgecase {

// The one change of LocationChoice, with the rule that it is a choice of.
struct LocationChange {
  std::string cause;  // "rule=alternative"
  const char* rule = "";
  int ruling = 0;
  LocationChoice choice;
};

// Every alternative of where attributes but depth are evaluated, beside what is chosen.
std::vector<LocationChange> locations_beside(const LocationChoice& chosen);

// Every alternative of where the depths of samples are evaluated, beside what is chosen.
std::vector<LocationChange> depth_locations_beside(const LocationChoice& chosen);

// What all smooth colours of a case are evaluated by, where the policy's own choice does not yield
// them; without a cause where there is no such thing.
struct FollowedLocation {
  std::string cause;
  std::string rule = "attribute.smooth";
  int ruling = 9;

  // Is the fragment's colour another than the policy's place yields, and has it so?
  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedLocation followed_location(const ValueContext& context, const Rendering& rendered);

// The same of gl_FragCoord.z.
struct FollowedDepth {
  std::string cause;
  std::string rule = "fragment.depth";
  int ruling = 9;

  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedDepth followed_depth(const ValueContext& context, const Rendering& rendered);

// Does a primitive with this depth have gl_FragCoord.z so where a choice evaluates it?
bool yields_depth(const ValueContext& context, const Fragment& fragment, const Interpolant& depth,
                  const LocationChoice& choice);

}  // namespace edgecase
