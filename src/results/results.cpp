// SPDX-License-Identifier: MIT
#include "results/results.h"

#include <algorithm>

namespace edgecase {

std::map<Verdict, std::size_t> count_verdicts(const Results& results, std::size_t index) {
  std::map<Verdict, std::size_t> counts;
  for (const CaseOutline& one : results.cases.outlines())
    if (index < one.answers.size()) ++counts[one.answers[index].verdict];
  return counts;
}

std::size_t count_unexpected(const Results& results) {
  std::size_t count = 0;
  for (const CaseOutline& one : results.cases.outlines())
    count += static_cast<std::size_t>(std::ranges::count_if(
        one.answers, [](const ResultOutline& answer) { return is_unexpected(answer.standing); }));
  return count;
}

std::size_t count_unexpected(const Results& results, std::size_t renderer) {
  const auto stands_out = [&](const CaseOutline& one) {
    return renderer < one.answers.size() && is_unexpected(one.answers[renderer].standing);
  };
  return static_cast<std::size_t>(std::ranges::count_if(results.cases.outlines(), stands_out));
}

}  // namespace edgecase
