// SPDX-License-Identifier: MIT
#include "run/last_failed.h"

#include <algorithm>

namespace edgecase {

NamedCases unexpected_cases(const Results& results) {
  NamedCases named;
  for (const CaseResults& one : results.cases)
    if (!one.expect_failures.empty() || std::ranges::any_of(one.results, [](const Result& result) {
          return is_unexpected(result.standing);
        }))
      named.ids.insert(one.id);
  for (const Diagnostic& diagnostic : results.diagnostics) named.files.insert(diagnostic.file);
  return named;
}

}  // namespace edgecase
