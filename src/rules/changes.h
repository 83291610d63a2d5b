// SPDX-License-Identifier: MIT
//
// Changes: the alternatives of a rule besides the chosen one, to be tried one after another.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/cause.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// Another alternative of one rule.
struct Change {
  AlternativeId id;
  // For sample.positions, whose alternative `swapped` has a placement for each pair of samples.
  std::optional<SamplePlacement> placement = {};

  void apply(RuleChoices& choices) const;
  RuleChoices applied_to(RuleChoices choices) const {
    apply(choices);
    return choices;
  }
};
using Changes = std::vector<Change>;

// The cause of all changes together, without repetition.
Cause cause_of(const Changes& changes);
RuleChoices applied(const Changes& changes, RuleChoices choices);

// The alternatives of a rule, except the chosen one.
Changes changes_beside(RuleId rule, const RuleChoices& chosen);
// The change from one choice of the rule to another; none if both are the same.
std::optional<Change> change_between(RuleId rule, const RuleChoices& from, const RuleChoices& to);

// The traits that decide which rules affect a primitive's coverage.
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

// The alternatives of every rule that affects what the primitive covers, rule by rule.
std::vector<Changes> coverage_changes(const CoverageTraits& traits, const RuleChoices& chosen);
// The changes from one choice to another, one for each such rule in which they differ; also the
// ties of polygons, if the other choice draws lines as areas. No cause is searched for among those:
// with free ties, areas draw nearly anything.
Changes coverage_changes_between(const ScenePrimitive& primitive, const Target& target,
                                 const RuleChoices& from, const RuleChoices& to);

// The alternatives of every rule that affects a scene's per-fragment operations.
Changes operations_changes(const Scene& scene, const RuleChoices& chosen);

// The rules that affect lookups of textures, in the order of their ids.
const std::vector<RuleId>& lookup_rules();

// The rules that affect what primitives cover, in the order of their ids.
const std::vector<RuleId>& coverage_rules();

// One character per alternative of these rules, rule by rule, and a last one for window.origin: '1'
// if the set has it, else '0'; empty for an empty set. And the inverse.
std::string text_of_refuted(const AlternativeSet& refuted);
std::optional<AlternativeSet> parse_refuted(std::string_view text);

}  // namespace edgecase
