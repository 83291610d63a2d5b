// SPDX-License-Identifier: MIT
//
// Resuming a run that ended early: the answers that its results hold are taken over, and the rest
// of the cases is run. What comes of both, merged (run/merge.h), equals to the byte what a run
// without an end in between makes.
//
// An answer is taken over where the text of its case file is what it was. Asked for again is what
// depends on further files, meshes and images, which may have changed unseen; and a case for which
// some renderer could not be had at all. A crash or an answer that came too late is an answer: were
// they asked for again, a run could be caught at one case for ever.
#pragma once

#include <string>
#include <variant>

#include "results/results.h"
#include "run/run_difference.h"
#include "run/selection.h"

namespace edgecase {

struct Resumption {
  Results held;  // the earlier results without the cases that are run again
  Suite rest;    // the cases that are yet to be run, and all diagnostics
};

// Divides a suite. A sentence instead where the earlier results hold a case that the suite leaves
// out although its file is there: it would be lost. Whether both are one run is not asked here.
std::variant<Resumption, std::string> resume(const Suite& suite, MergePart earlier);

}  // namespace edgecase
