// SPDX-License-Identifier: MIT
//
// The cases of earlier results that were not as expected, to be run once more.
#pragma once

#include "results/results.h"
#include "run/selection.h"

namespace edgecase {

// Cases of which any renderer's result is not as expected or whose hand-drawn truth is not met, and
// the files that could not be loaded, whose cases nobody knows.
NamedCases unexpected_cases(const Results& results);

}  // namespace edgecase
