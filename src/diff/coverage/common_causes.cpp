// SPDX-License-Identifier: MIT
#include "diff/coverage/common_causes.h"

#include <algorithm>
#include <optional>

#include "diff/findings/patience.h"
#include "raster/rasterizer.h"
#include "rules/change_search.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

class Witnesses {
 public:
  Witnesses(const CauseQuestion& question, const PrimitiveCoverage& own)
      : question_(question),
        own_{&question.primitive, &own},
        changes_(joined(coverage_changes(coverage_traits(question.primitive, question.target),
                                         question.chosen))) {
    if (question.profile == nullptr) return;
    // A profile's differences may include rules that are not searched.
    const Changes more = coverage_changes_between(question.primitive, question.target,
                                                  question.chosen, *question.profile);
    changes_.insert(changes_.end(), more.begin(), more.end());
  }

  // None if a part of the cause is no alternative, or if several alternatives share its name.
  std::optional<RuleChoices> choice_of(const Cause& cause) const {
    RuleChoices choice = question_.chosen;
    for (const AlternativeId part : cause.parts) {
      const auto change = std::ranges::find(changes_, part, &Change::id);
      if (change == changes_.end()) return std::nullopt;
      change->apply(choice);
    }
    if (!draws(own_, choice)) return std::nullopt;
    return choice;
  }

  // True if the choice, with at most one more alternative, draws another primitive as it was drawn.
  bool explains(const RuleChoices& choice, const DrawnPrimitive& other) const {
    if (draws(other, choice)) return true;
    return std::ranges::any_of(changes_, [&](const Change& change) {
      const RuleChoices changed = change.applied_to(choice);
      return covers_otherwise(changed, choice) && draws(other, changed) && draws(own_, changed);
    });
  }

 private:
  bool covers_otherwise(const RuleChoices& one, const RuleChoices& other) const {
    const PrimitiveKind kind = question_.primitive.kind;
    return one.of(kind) != other.of(kind);
  }

  bool draws(const DrawnPrimitive& one, const RuleChoices& choice) const {
    Patience::check();
    return covered_samples(*one.primitive, question_.target, choice.of(one.primitive->kind),
                           question_.reported) == one.coverage->drawn;
  }

  const CauseQuestion& question_;
  const DrawnPrimitive own_;
  Changes changes_;
};

}  // namespace

std::vector<Cause> common_causes(const CauseQuestion& question, const PrimitiveCoverage& own,
                                 const std::vector<Cause>& causes,
                                 std::span<const DrawnPrimitive> others) {
  const Witnesses witnesses(question, own);
  std::vector<Cause> common;
  for (const Cause& cause : causes) {
    const auto choice = witnesses.choice_of(cause);
    if (!choice || std::ranges::all_of(others, [&](const DrawnPrimitive& other) {
          return witnesses.explains(*choice, other);
        }))
      common.push_back(cause);
  }
  return common;
}

}  // namespace edgecase
