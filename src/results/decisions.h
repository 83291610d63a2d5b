// SPDX-License-Identifier: MIT
//
// Decisions: what a reviewer made of answers, case by case, for `edgecase bless --from`.
//
//   {"edgecase_decisions": 1,
//    "renderer": "osmesa:softpipe",
//    "decisions": [
//      {"case": "points/centres", "renderer": "egl:softpipe",
//       "verdict": "violation", "fingerprint": "0123456789abcdef",
//       "expected": {"verdict": "permitted", "fingerprint": "fedcba9876543210"},
//       "decision": "accept", "reason": "known since 22.3", "link": "https://..."}]}
//
// A decision names the answer that it was made on, and in "expected" the entry that expectations
// had then; absent or null: they had none. "renderer" of the file holds for decisions without one;
// "link" may be absent. So a decision that comes late decides nothing: where the answer or the
// entry is another one by now, it is refused, and others hold all the same.
//
// "accept" makes the answer the expected one; of a case that agrees, it removes the entry. "reject"
// writes nothing: the answer stays unexpected. It removes an entry only where that expects the very
// answer that is rejected; one that expects another answer stays, since what was accepted once is
// no part of the decision.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "results/expectations.h"

namespace edgecase {

struct Decision {
  std::string id;  // of the case
  std::string renderer;
  Judgement seen;
  std::optional<Judgement> expected;  // the entry that was seen, or nothing
  bool accepts = false;
  std::string reason;  // never empty
  std::string link;    // or empty
};

// A sentence that says what is wrong and where, otherwise: unknown keys, two decisions on one case
// and renderer, a missing reason.
std::variant<std::vector<Decision>, std::string> parse_decisions(const std::string& text);

// What becomes of one decision: refused, with the reason; or a change, or nothing to change.
struct DecisionOutcome {
  const Decision* decision = nullptr;
  std::string refusal;                      // empty: it holds
  std::optional<ExpectationChange> change;  // points into the current expectations
};

// Of the decisions on the renderer at `index`, in their order.
std::vector<DecisionOutcome> apply_decisions(const Results& results, std::size_t index,
                                             const Expectations& current,
                                             std::span<const Decision> decisions);

}  // namespace edgecase
