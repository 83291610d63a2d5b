// SPDX-License-Identifier: MIT
#include "run/last_failed.h"

#include <algorithm>

namespace edgecase {

NamedCases unexpected_cases(const Results& results) {
  NamedCases named;
  for (const CaseOutline& one : results.cases.outlines())
    if (one.expect_failures > 0 ||
        std::ranges::any_of(one.answers, [](const ResultOutline& answer) {
          return is_unexpected(answer.standing);
        }))
      named.ids.insert(one.id);
  for (const Diagnostic& diagnostic : results.diagnostics) named.files.insert(diagnostic.file);
  return named;
}

}  // namespace edgecase
