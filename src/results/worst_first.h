// SPDX-License-Identifier: MIT
//
// Worst first: the order in which people are told what a run found.
//
// What is not allowed comes before what is contested, and that before what is allowed, wherever
// something is listed: the disagreements of a case, the cases of a page, the tests of a suite.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "results/results.h"

namespace edgecase {

// The disagreements of a result: illegal ones, contested ones, legal ones; otherwise in their
// order.
std::vector<const Disagreement*> worst_first(const Result& result);

// The answer of one renderer to one case.
struct AnswerPlace {
  std::size_t one = 0;       // index in Results::cases
  std::size_t renderer = 0;  // index in Results::renderers
};

using WantedAnswer = std::function<bool(const ResultOutline&)>;

// The answers that are wanted, by their verdict: violation, contested, permitted, convention,
// agree, not-run. Within a verdict those come first whose first disagreement is of a cause, or
// without one of a rule and kind, that more of the renderer's answers begin with. Ties
// stay in the order of cases and renderers.
std::vector<AnswerPlace> worst_first(const Results& results, const WantedAnswer& is_wanted);

// The same of answers that come one after the other, in the order of cases and renderers.
class WorstFirst {
 public:
  WorstFirst();
  ~WorstFirst();

  // An answer that is wanted.
  void add(AnswerPlace place, const Result& result);
  // To be called once.
  std::vector<AnswerPlace> take();

 private:
  class Entries;
  std::unique_ptr<Entries> entries_;
};

}  // namespace edgecase
