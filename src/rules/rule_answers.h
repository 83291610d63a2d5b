// SPDX-License-Identifier: MIT
//
// What all answers of a renderer on a surface say of each rule: which of its alternatives remain.
//
// An answer is asked about a rule if it tells two of its alternatives apart. It speaks against each
// alternative by which one of its primitives, or all of its values, would be another, and for the
// rest; of a difference that alternatives of several rules explain, it says nothing. Answers only
// add up: their order does not matter, and nothing is kept of each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/result.h"

namespace edgecase {

struct RuleAnswers {
  RuleId rule = RuleId::none;
  std::size_t asked = 0;             // answers
  std::vector<std::size_t> against;  // answers, by alternative in the catalogue's order
  friend bool operator==(const RuleAnswers&, const RuleAnswers&) = default;

  // Answers that the alternative of this index agrees with.
  std::size_t speaking_for(std::size_t alternative) const { return asked - against[alternative]; }
};

// The alternatives that most answers speak for, if those are nine in ten: "left-bottom", or, where
// nothing tells them apart, "left-bottom or left-top"; else kNoneKnown.
inline constexpr const char* kNoneKnown = "none known";
std::string remaining_of(const RuleAnswers& answers);

// How many answers speak for each alternative, those for which none does left out.
std::vector<std::pair<std::string, std::size_t>> names_spoken_for(const RuleAnswers& answers);

// {"rule", "asked", "remain", "for": {ALTERNATIVE: answers}}, for every kind of document of the
// JSON library.
template <class Json>
void to_json(Json& json, const RuleAnswers& answers) {
  json = {{"rule", name_of(answers.rule)},
          {"asked", answers.asked},
          {"remain", remaining_of(answers)},
          {"for", Json::object()}};
  for (const auto& [name, count] : names_spoken_for(answers)) json["for"][name] = count;
}

// What an answer speaks against.
AlternativeSet contradicted_by(const Result& result);

class RuleAnswersGatherer {
 public:
  void add(const Result& answer) { add(contradicted_by(answer)); }
  void add(const AlternativeSet& against);  // of one answer
  // Of the rules about which an answer was asked, in the catalogue's order.
  std::vector<RuleAnswers> answers() const;

 private:
  static constexpr std::size_t kRules = values_of<RuleId>().size();

  std::array<std::uint32_t, kRules> asked_{};
  std::array<std::array<std::uint32_t, AlternativeSet::kMostOfARule>, kRules> against_{};
};

}  // namespace edgecase
