// SPDX-License-Identifier: MIT
//
// Judge: from compared results to verdicts, over all results of one renderer on one surface.
//
// Two things can only be said of a whole run. Lines are read with one catalogued snap, the same for
// all of them: the first of those under which most cases are legal (ruling 1). And of several
// causes that reproduce a primitive equally well, the one whose alternatives explain most
// primitives of the run, and are refuted by fewest cases, is the likeliest: it is what the renderer
// does everywhere. Where what was drawn is legal, one that the specification leaves open comes
// before one that it does not, unless the run refutes it and no case refutes a fault that explains
// more. Judging is a function of the results alone, so judging merged shards gives what judging the
// whole run gives.
//
// Both make a RunReading. Whoever has a run may read it once, and then judge any result, one of the
// run or a new one, as the run as a whole reads it.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>

#include "model/policy.h"
#include "model/result.h"

namespace edgecase {

// What a run says of each of its results.
struct RunReading {
  std::string line_snap = "none";  // the catalogued snap with which lines are read
  // How many primitives of the run an alternative helps to reproduce, alone or with another, less
  // the cases that refute it. One that is not there counts 0.
  std::map<AlternativeId, std::ptrdiff_t> alternatives;
  AlternativeSet refuted;  // those that some case refutes
};

// The reading of all results of one renderer on one surface, which compare() made; those without a
// rendering say nothing. Judged results have the reading that they had before.
RunReading read_run(std::span<Result* const> results);

// Fills legality (of lines, and by the basis of rulings), cause, ruling, verdict and fingerprint of
// every result that ran, under the reading of a run that they need not be part of. Judging twice
// changes nothing.
void judge(std::span<Result* const> results, Latitude latitude, const RunReading& reading);

// The same under their own reading. Returns the name of the snap with which lines were read.
std::string judge(std::span<Result* const> results, Latitude latitude);

// ------------------------------------------------------------------------------- verdicts of parts
//
// Verdicts below those of a whole case: of one difference, and of each pixel.

// Causes and legality have been decided. Never agree: something differs.
Verdict verdict_of(const Disagreement& disagreement, Latitude latitude);
Verdict verdict_of(const ValueAggregate& values, Latitude latitude);

// Says of the pixels that are counted how they fare: compare() has all of them agree. `same` stays.
void count_pixels(Result& result, Latitude latitude);

}  // namespace edgecase
