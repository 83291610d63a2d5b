// SPDX-License-Identifier: MIT
#include "results/results.h"

namespace edgecase {

std::map<Verdict, std::size_t> count_verdicts(const Results& results, std::size_t index) {
  std::map<Verdict, std::size_t> counts;
  for (const CaseResults& one : results.cases)
    if (index < one.results.size()) ++counts[one.results[index].verdict];
  return counts;
}

}  // namespace edgecase
