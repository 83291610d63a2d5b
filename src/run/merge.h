// SPDX-License-Identifier: MIT
//
// Merging: the results of the parts of a run become the results of the whole.
//
// Parts are the shards of one run, or runs of different cases under the same options. Their cases
// stand side by side, and all are judged again, together: which snap lines are read with and which
// cause is the likeliest is a matter of the whole run. So what is merged from shards equals, to the
// byte, what one run makes of all cases. Answers that a part asked for twice stay as they are.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "results/results.h"
#include "run/run_difference.h"

namespace edgecase {

// Merges at least one part. A sentence instead where parts do not belong together: another version
// of the tool, policy, renderer or suite, a case or a share that two of them have. A share that is
// missing is such a sentence too, unless `partial`: then the results are interrupted ones.
// Known faults are not applied, and case files' texts are not known.
std::variant<Results, std::string> merge_results(std::vector<MergePart> parts, bool partial);

}  // namespace edgecase
