// SPDX-License-Identifier: MIT
//
// Inference: which alternatives of the catalogue draw what a renderer draws.
//
// Every combination of the alternatives that matter for a kind of primitive is a candidate, nearly
// two thousand for lines. They compete in rounds: each round uses twice as many scenes as the one
// before and keeps the best third. The few that are left, and for each rule the nearest other
// choices, are compared with all scenes. Agreement means a whole scene: every pixel.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "profile/evidence/drawing.h"
#include "profile/evidence/tally.h"
#include "rules/choices.h"

namespace edgecase {

// The alternative found for one rule.
struct InferredRule {
  RuleId rule = RuleId::none;
  std::string alternative;
  Rate rate;              // of the whole choice, over all scenes
  std::string runner_up;  // the best other alternative of this rule, all else being equal
  Rate runner_up_rate;
};

struct Inference {
  RuleChoices choice;
  Rate rate;
  std::vector<InferredRule> rules;  // those that matter in the scenes
};

// The rules whose alternatives are tried.
enum class OpenRules {
  coverage,   // all that matter, except the next two
  width,      // line.width
  placement,  // sample.positions
};

// Which rules are open, and the choices for the others.
struct InferenceQuestion {
  PrimitiveKind kind = PrimitiveKind::triangle;
  RuleChoices start;  // preferred if candidates tie: fewest deviating rules
  OpenRules open = OpenRules::coverage;
};

// Failed observations are ignored; all others must have one primitive of the kind. Without any, the
// start is returned with an empty rate.
Inference infer(const InferenceQuestion& question,
                std::span<const Observation* const> observations);

}  // namespace edgecase
