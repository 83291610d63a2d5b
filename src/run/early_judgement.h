// SPDX-License-Identifier: MIT
//
// Early judgement: what can be said of one answer while the run still goes on.
//
// Verdicts are a matter of the whole run (diff/judge.h): the reading of lines decides whether a
// line is legal, the likeliest cause whether a choice is open. What cannot change any more is
// whether anything differs at all, and mostly where. So a run that ends after so many unexpected
// cases counts those that are unexpected however the run will be read; others are found at its end.
#pragma once

#include "model/policy.h"
#include "results/expectations.h"

namespace edgecase {

// Is the answer, compared and not judged, unexpected however the run will be read? `entry`: what is
// expected of it, or null.
bool is_surely_unexpected(const Result& result, Latitude latitude, const Expectation* entry);

}  // namespace edgecase
