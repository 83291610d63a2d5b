// SPDX-License-Identifier: MIT
//
// Decisions: a reviewer's decisions on answers, case by case, for `edgecase bless --from`.
//
//   {"edgecase_decisions": 2,
//    "renderer": "egl:softpipe",
//    "decisions": [
//      {"case": "points/centres", "renderer": "egl:softpipe",
//       "verdict": "violation", "fingerprint": "0123456789abcdef",
//       "decision": "accept", "reason": "known since 22.3", "link": "https://..."}]}
//
// "renderer" of the file holds for decisions without one; "link" may be absent. A decision names
// the answer on which it was made. If the answer has changed since, or is known by now, the
// decision is refused; others still hold.
//
// "accept" makes the answer a known fault of the renderer's driver; answers that are accepted for
// one reason and show one rule and cause become one fault. "reject" writes nothing: the answer
// stays unexpected.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "results/blessing.h"

namespace edgecase {

struct Decision {
  std::string id;  // of the case
  std::string renderer;
  Judgement seen;
  bool accepts = false;
  std::string reason;  // never empty
  std::string link;    // or empty
};

// Otherwise a sentence that says what is wrong and where: unknown keys, two decisions on one case
// and renderer, a missing reason.
std::variant<std::vector<Decision>, std::string> parse_decisions(const std::string& text);

// Whether one decision holds.
struct DecisionOutcome {
  const Decision* decision = nullptr;
  std::string refusal;  // the reason; empty: it holds
};

// Of the decisions on the renderer at `index`, in their order. Standings must have been set.
std::vector<DecisionOutcome> weigh_decisions(const Results& results, std::size_t index,
                                             std::span<const Decision> decisions);

// The changes to the known faults of the renderer's driver by the decisions that hold.
std::vector<FaultChange> plan_decisions(const Results& results, std::size_t index,
                                        const KnownFaults& current,
                                        std::span<const DecisionOutcome> outcomes);

}  // namespace edgecase
