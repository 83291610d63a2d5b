// SPDX-License-Identifier: MIT
//
// Reads what a case file says of samples: how many a pixel of the target has, where they lie, and
// how a draw makes use of them (GL 4.6 core, 14.3.1).
#pragma once

#include <string>
#include <vector>

#include "casefile/fields.h"
#include "casefile/scene_reader.h"

namespace edgecase {

// The keys of a draw's state that read_multisampling reads.
std::vector<std::string> multisampling_keys();

// "samples" and "sample_positions" of a target whose surface has been read. A faulty number of
// samples becomes 0: not known.
void read_samples(const ObjectReader& object, TargetFields& fields, Findings& findings);

// The keys of a state that say how samples are used. Each of them is refused where `samples`, the
// target's, is 1; 0 is not known, and what hangs on it is not checked.
Multisampling read_multisampling(const ObjectReader& state, int samples, Findings& findings);

}  // namespace edgecase
