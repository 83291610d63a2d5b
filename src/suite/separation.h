// SPDX-License-Identifier: MIT
//
// Separation: does the suite tell the alternatives of every rule from one another?
//
// A suite that renders the same under two alternatives cannot say which of them a renderer follows.
// For every rule of coverage and each pair of its alternatives, the cases are counted in which
// exact covers other pixels, or other samples of them, where their positions are those of the case
// or the standard ones; of draws without GL_MULTISAMPLE those, too, in which samples have other
// depths. Ties are counted too: the cases in which something lies exactly on a boundary, so that
// `open` and `closed` boundaries cover differently.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "model/rule_id.h"
#include "suite/case_store.h"

namespace edgecase {

struct SeparationMatrix {
  std::string rule;
  std::vector<std::string> alternatives;
  // cases[i][j]: how many cases tell alternative i from alternative j.
  std::vector<std::vector<std::size_t>> cases;

  // The least of all pairs.
  std::size_t least() const;
};

struct Separation {
  std::size_t cases = 0;
  std::size_t with_ties = 0;
  std::vector<SeparationMatrix> matrices;
};

// Beside the rule in question, policy `opengl` holds.
Separation measure_separation(const CaseStore& cases);

// Two alternatives of a rule by their places in its list, the later one first.
struct AlternativePair {
  RuleId rule = RuleId::none;
  std::size_t later = 0;
  std::size_t earlier = 0;
  friend auto operator<=>(const AlternativePair&, const AlternativePair&) = default;
};

// The pairs that a case tells apart: of the rules of coverage as above, and of other rules that the
// case names, by anything that exact answers.
std::vector<AlternativePair> pairs_told_apart(const Case& one);

}  // namespace edgecase
