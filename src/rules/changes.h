// SPDX-License-Identifier: MIT
//
// Changes: the alternatives of a rule beside the one that is chosen, to try one after another.
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
  // Of sample.positions, whose alternative `swapped` is one for each pair of samples.
  std::optional<SamplePlacement> placement = {};

  void apply(RuleChoices& choices) const;
  RuleChoices applied_to(RuleChoices choices) const {
    apply(choices);
    return choices;
  }
};
using Changes = std::vector<Change>;

// Without repetition, the cause of all of them together.
Cause cause_of(const Changes& changes);
RuleChoices applied(const Changes& changes, RuleChoices choices);

// The alternatives of a rule, but for the one that is chosen.
Changes changes_beside(RuleId rule, const RuleChoices& chosen);
// What leads from one choice of the rule to another; nothing where both are the same.
std::optional<Change> change_between(RuleId rule, const RuleChoices& from, const RuleChoices& to);

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

// The alternatives of every rule that has a say in what the primitive covers, rule by rule.
std::vector<Changes> coverage_changes(const CoverageTraits& traits, const RuleChoices& chosen);
// What leads from one choice to another: a change for each such rule in which they differ; the ties
// of polygons too, where the other draws lines as areas. No cause is searched for among those: with
// ties to choose, areas draw nearly anything.
Changes coverage_changes_between(const ScenePrimitive& primitive, const Target& target,
                                 const RuleChoices& from, const RuleChoices& to);

// The same of every rule that has a say in what becomes of a scene's fragments.
Changes fate_changes(const Scene& scene, const RuleChoices& chosen);

// The rules that have a say in lookups of textures, in the order of their ids.
const std::vector<RuleId>& lookup_rules();

// The rules that have a say in what primitives cover, in the order of their ids.
const std::vector<RuleId>& coverage_rules();

// A character per alternative of these rules, rule by rule, and a last one for window.origin: '1'
// where the set has it, else '0'; nothing of an empty set. And the set that such a text is of.
std::string text_of_refuted(const AlternativeSet& refuted);
std::optional<AlternativeSet> parse_refuted(std::string_view text);

}  // namespace edgecase
