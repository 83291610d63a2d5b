// SPDX-License-Identifier: MIT
//
// Judge: from compared results to verdicts, over all results of one renderer on one surface.
//
// Two things can only be said of a whole run. Lines are read with one catalogued snap, the same for
// all of them: the first of those under which most cases are legal (ruling 1). And of several
// causes that reproduce a primitive equally well, the one whose alternatives explain most
// primitives of the run, and are refuted by fewest cases, is the likeliest: it is what the renderer
// does everywhere. Where what was drawn is legal, one that the specification leaves open comes
// before one that it does not. Judging is a function of the results alone, so judging merged shards
// gives what judging the whole run gives.
#pragma once

#include <span>
#include <string>

#include "model/policy.h"
#include "model/result.h"

namespace edgecase {

// Fills legal (of lines), cause, ruling, verdict and fingerprint of every result that ran, and
// returns the name of the snap with which lines were read. Judging twice changes nothing.
std::string judge(std::span<Result* const> results, Latitude latitude);

}  // namespace edgecase
