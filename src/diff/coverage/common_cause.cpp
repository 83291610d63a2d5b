// SPDX-License-Identifier: MIT
#include "diff/coverage/common_cause.h"

#include <algorithm>
#include <optional>

#include "diff/coverage/alternatives.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

class Witnesses {
 public:
  Witnesses(const CauseQuestion& question, const PrimitiveCoverage& own)
      : question_(question),
        own_{&question.primitive, &own},
        rules_(alternatives_beside(question.primitive, question.target, question.chosen)) {
    if (question.profile == nullptr) return;
    // What a profile differs in may go beyond what is searched for.
    rules_.push_back(
        changes_between(question.primitive, question.target, question.chosen, *question.profile));
  }

  // None where a part of the cause is no alternative, or one of several of a name.
  std::optional<CoverageChoice> choice_of(const std::string& cause) const {
    CoverageChoice choice = question_.chosen;
    for (const std::string& part : parts_of(cause)) {
      const Change* const change = find(part);
      if (change == nullptr) return std::nullopt;
      change->apply(choice);
    }
    if (!draws(own_, choice)) return std::nullopt;
    return choice;
  }

  // Is another primitive drawn so, with one more alternative at most?
  bool explains(const CoverageChoice& choice, const DrawnPrimitive& other) const {
    if (draws(other, choice)) return true;
    return std::ranges::any_of(rules_, [&](const RuleAlternatives& rule) {
      return std::ranges::any_of(rule, [&](const Change& change) {
        const CoverageChoice changed = change.applied_to(choice);
        return changed != choice && draws(other, changed) && draws(own_, changed);
      });
    });
  }

 private:
  const Change* find(const std::string& part) const {
    for (const RuleAlternatives& rule : rules_)
      for (const Change& change : rule)
        if (change.cause == part) return &change;
    return nullptr;
  }

  bool draws(const DrawnPrimitive& one, const CoverageChoice& choice) const {
    return covered_samples(*one.primitive, question_.target, choice, question_.reported) ==
           one.coverage->drawn;
  }

  const CauseQuestion& question_;
  const DrawnPrimitive own_;
  std::vector<RuleAlternatives> rules_;
};

}  // namespace

std::vector<std::string> common_causes(const CauseQuestion& question, const PrimitiveCoverage& own,
                                       const std::vector<std::string>& causes,
                                       std::span<const DrawnPrimitive> others) {
  const Witnesses witnesses(question, own);
  std::vector<std::string> common;
  for (const std::string& cause : causes) {
    const auto choice = witnesses.choice_of(cause);
    if (!choice || std::ranges::all_of(others, [&](const DrawnPrimitive& other) {
          return witnesses.explains(*choice, other);
        }))
      common.push_back(cause);
  }
  return common;
}

}  // namespace edgecase
