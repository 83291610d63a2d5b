// SPDX-License-Identifier: MIT
//
// Early judgement: what can be said of one answer while the run still goes on.
//
// Verdicts are a matter of the whole run (diff/judge.h): the reading of lines decides whether a
// line is legal. What cannot change any more is that other things are forbidden, and that a
// renderer did not answer. So a run that ends after so many unexpected cases counts those that are
// unexpected however the run will be read; others are found at its end.
#pragma once

#include <span>

#include "model/case.h"
#include "model/policy.h"
#include "results/known_faults.h"

namespace edgecase {

// Is the answer, compared and not judged, unexpected however the run will be read? `faults`: those
// that the renderer's release may have.
bool is_surely_unexpected(const Case& one, const Result& result, Latitude latitude,
                          std::span<const KnownFault* const> faults);

}  // namespace edgecase
