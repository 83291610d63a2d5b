// SPDX-License-Identifier: MIT
//
// Equality of cases, member by member, for tests.
#pragma once

#include "results/case_list.h"

namespace edgecase {

// Expects that a results file tells the same of both.
void expect_case(const CaseResults& a, const CaseResults& b);

}  // namespace edgecase
