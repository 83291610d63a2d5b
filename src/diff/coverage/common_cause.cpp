// SPDX-License-Identifier: MIT
#include "diff/coverage/common_cause.h"

#include <algorithm>
#include <optional>

#include "raster/rasterizer.h"
#include "rules/changes.h"

namespace edgecase {
namespace {

class Witnesses {
 public:
  Witnesses(const CauseQuestion& question, const PrimitiveCoverage& own)
      : question_(question),
        own_{&question.primitive, &own},
        rules_(coverage_changes(coverage_traits(question.primitive, question.target),
                                question.chosen)) {
    if (question.profile == nullptr) return;
    // What a profile differs in may go beyond what is searched for.
    rules_.push_back(coverage_changes_between(question.primitive, question.target, question.chosen,
                                              *question.profile));
  }

  // None where a part of the cause is no alternative, or one of several of a name.
  std::optional<RuleChoices> choice_of(const Cause& cause) const {
    RuleChoices choice = question_.chosen;
    for (const AlternativeId part : cause.parts) {
      const Change* const change = find(part);
      if (change == nullptr) return std::nullopt;
      change->apply(choice);
    }
    if (!draws(own_, choice)) return std::nullopt;
    return choice;
  }

  // Is another primitive drawn so, with one more alternative at most?
  bool explains(const RuleChoices& choice, const DrawnPrimitive& other) const {
    if (draws(other, choice)) return true;
    return std::ranges::any_of(rules_, [&](const Changes& rule) {
      return std::ranges::any_of(rule, [&](const Change& change) {
        const RuleChoices changed = change.applied_to(choice);
        return covers_otherwise(changed, choice) && draws(other, changed) && draws(own_, changed);
      });
    });
  }

 private:
  bool covers_otherwise(const RuleChoices& one, const RuleChoices& other) const {
    const PrimitiveKind kind = question_.primitive.kind;
    return one.of(kind) != other.of(kind);
  }

  const Change* find(AlternativeId part) const {
    for (const Changes& rule : rules_)
      for (const Change& change : rule)
        if (change.id == part) return &change;
    return nullptr;
  }

  bool draws(const DrawnPrimitive& one, const RuleChoices& choice) const {
    return covered_samples(*one.primitive, question_.target, choice.of(one.primitive->kind),
                           question_.reported) == one.coverage->drawn;
  }

  const CauseQuestion& question_;
  const DrawnPrimitive own_;
  std::vector<Changes> rules_;
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
