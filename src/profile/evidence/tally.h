// SPDX-License-Identifier: MIT
//
// Tally: which alternatives of a rule yield what a renderer drew.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/policy.h"
#include "profile/evidence/trait.h"
#include "rules/choices.h"

namespace edgecase {

// The alternative of a trait if none of the catalogue yields everything.
inline constexpr const char* kNoneFits = "none fits";

// The names of a rule's alternatives, in the catalogue's order.
std::vector<std::string> names_of_alternatives(RuleId rule);

// The choices with another alternative of one rule; the name must be one of the rule's.
RuleChoices with_alternative(RuleChoices choices, RuleId rule, const std::string& alternative);

// The choices under each alternative of a rule, in the catalogue's order, all else being equal.
std::vector<RuleChoices> choices_by_alternative(const RuleChoices& choices, RuleId rule);

// The policy of rules, and the same with another alternative of one rule.
Policy policy_of(const Choices& rules);
Policy policy_with(const Choices& rules, RuleId rule, const std::string& alternative);

// The trait of the alternative with most agreeing observations, with the next best as runner-up.
// Among equals, `standard` comes first, then the first of the list.
Trait leading(TraitId id, std::span<const std::string> names, std::span<const std::size_t> agreeing,
              std::size_t of, std::size_t standard = 0);

// For each of several facts, whether an alternative yields it.
using Facts = std::vector<bool>;

// Counts, observation by observation, which of a rule's alternatives yield it. An observation that
// all of them yield is evidence for none.
class Tally {
 public:
  // With all alternatives; the rule's standard one is preferred among equals.
  explicit Tally(RuleId rule);
  // `standard`: the index of the preferred alternative.
  explicit Tally(std::vector<std::string> names, std::size_t standard = 0)
      : names_(std::move(names)), agreeing_(names_.size()), standard_(standard) {}

  // yields[a]: whether alternative a yields the observation.
  void add(const std::vector<bool>& yields);
  // facts[a][i]: whether alternative a yields fact i; all have the same number of facts.
  void add_all(const std::vector<Facts>& facts);

  // The rate covers observations that some alternatives yield and some do not. Those that none
  // yields are mentioned in a remark, or counted as well.
  enum class None { remarked, counted };
  Trait trait(TraitId id, None none = None::remarked) const;
  // The alternative that yields every observation; otherwise kNoneFits, with the closest one as
  // runner-up.
  Trait fitting(TraitId id) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::size_t> agreeing_;
  std::size_t standard_;
  std::size_t of_ = 0;    // observations that some yield and some do not
  std::size_t none_ = 0;  // observations that none yields
  std::size_t all_ = 0;
};

}  // namespace edgecase
