// SPDX-License-Identifier: MIT
//
// Verdicts on parts of a case: one difference, or each pixel.
#pragma once

#include "model/policy.h"
#include "model/result.h"

namespace edgecase {

// Cause and legality must have been decided. Never `agree`, since something differs.
Verdict verdict_of(const DisagreementClass& disagreement, Latitude latitude);
Verdict verdict_of(const ValueAggregate& values, Latitude latitude);

// Sorts the counted pixels by verdict; compare() counts all as agreeing. `same` is unchanged.
void count_pixels(Result& result, Latitude latitude);

}  // namespace edgecase
