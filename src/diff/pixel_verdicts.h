// SPDX-License-Identifier: MIT
//
// Verdicts below those of a whole case: of one difference, and of each pixel.
#pragma once

#include "model/policy.h"
#include "model/result.h"

namespace edgecase {

// Causes and legality have been decided. Never agree: something differs.
Verdict verdict_of(const Disagreement& disagreement, Latitude latitude);
Verdict verdict_of(const ValueAggregate& values, Latitude latitude);

// Says of the pixels that are counted how they fare: compare() has all of them agree. `same` stays.
void count_pixels(Result& result, Latitude latitude);

}  // namespace edgecase
