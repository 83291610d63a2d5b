// SPDX-License-Identifier: MIT
#include "results/results.h"

namespace edgecase {

std::map<Verdict, std::size_t> count_verdicts(const Results& results, std::size_t index) {
  std::map<Verdict, std::size_t> counts;
  for (const CaseOutline& one : results.cases.outlines())
    if (index < one.answers.size()) ++counts[one.answers[index].verdict];
  return counts;
}

}  // namespace edgecase
