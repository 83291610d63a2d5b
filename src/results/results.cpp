// SPDX-License-Identifier: MIT
#include "results/results.h"

namespace edgecase {

const char* name_of(Standing standing) {
  switch (standing) {
    case Standing::expected:
      return "expected";
    case Standing::unexpected:
      return "unexpected";
    case Standing::changed:
      return "changed";
    case Standing::unexpected_agreement:
      return "unexpected-agreement";
    case Standing::tolerated:
      return "tolerated";
    case Standing::flake:
      return "flake";
  }
  return "?";
}

std::map<Verdict, std::size_t> count_verdicts(const Results& results, std::size_t index) {
  std::map<Verdict, std::size_t> counts;
  for (const CaseResults& one : results.cases)
    if (index < one.results.size()) ++counts[one.results[index].verdict];
  return counts;
}

}  // namespace edgecase
