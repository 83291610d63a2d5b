// SPDX-License-Identifier: MIT
//
// Alternatives: the catalogue of the coverage rules as changes of a choice, to try one after
// another.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// One alternative of a rule, as a change of a choice.
struct Change {
  std::string cause;  // "rule=alternative"
  std::function<void(CoverageChoice&)> apply;

  CoverageChoice applied_to(CoverageChoice choice) const {
    apply(choice);
    return choice;
  }
};

// The alternatives of one rule, but for the one that is chosen.
using RuleAlternatives = std::vector<Change>;

// What decides which rules have a say in a primitive's coverage.
struct CoverageTraits {
  PrimitiveKind kind = PrimitiveKind::point;
  int samples = 1;  // of the target
  bool is_multisampled = false;
  bool is_switched_off = false;  // GL_MULTISAMPLE, on a target of several samples
  bool heeds_mask = false;
  bool is_wide = false;  // a line that is not 1 pixel wide
  bool is_clipped = false;
  bool is_culled_by_facing = false;
  friend bool operator==(const CoverageTraits&, const CoverageTraits&) = default;
};
CoverageTraits coverage_traits(const ScenePrimitive& primitive, const Target& target);

// The alternatives of every rule that has a say in the primitive's coverage.
std::vector<RuleAlternatives> alternatives_beside(const CoverageTraits& traits,
                                                  const CoverageChoice& chosen);
std::vector<RuleAlternatives> alternatives_beside(const ScenePrimitive& primitive,
                                                  const Target& target,
                                                  const CoverageChoice& chosen);

// What leads from one choice to another: a change for each rule in which they differ, of those that
// have a say in the primitive's coverage; the ties of polygons too, where the other draws lines as
// areas. No cause is searched for among those: with ties to choose, areas draw nearly anything.
std::vector<Change> changes_between(const ScenePrimitive& primitive, const Target& target,
                                    const CoverageChoice& from, const CoverageChoice& to);

// The alternative of a coverage rule that a choice holds; empty for other rules.
std::string choice_of(const CoverageChoice& choice, std::string_view rule);

// Every single alternative of the coverage rules as a cause, in one fixed order, and last
// "window.origin", which is no alternative of a primitive (see diff/upside_down.h).
std::span<const std::string> alternative_names();

}  // namespace edgecase
