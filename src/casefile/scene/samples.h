// SPDX-License-Identifier: MIT
//
// Reads what a case file says of samples: how many a pixel of the target has, where they lie, and
// how a draw makes use of them (GL 4.6 core, 14.3.1).
#pragma once

#include <string>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/scene/scene_reader.h"

namespace edgecase {

// The keys of a draw's state that read_multisampling reads.
std::vector<std::string> multisampling_keys();

// "samples" and "sample_positions" of a target whose surface has been read. A faulty number of
// samples becomes 0: not known.
void read_samples(const ObjectReader& object, TargetFields& fields, Findings& findings);

// The keys of a state that say how samples are used. Each of them is refused where `samples`, the
// target's, is 1; 0 is not known, and what hangs on it is not checked.
Multisampling read_multisampling(const ObjectReader& state, int samples, Findings& findings);

// Reads what a case file says of supersampling: a pattern of places within a pixel, and how much
// each of them counts (casefile/scene/patterns.h); or the passes one by one.

// "supersample" of a target whose samples have been read.
void read_supersample(const ObjectReader& object, TargetFields& fields, Findings& findings);

// Refuses a scene that would take too long: more than kMaxPassWork.
void check_pass_work(const Scene& scene, const TargetFields& fields, Findings& findings);

// Refuses drawings of coverage: each pass covers pixels of its own.
void check_no_drawing(const TargetFields& fields, const Place& drawing, Findings& findings);

// The definitions of "supersample" and of places within a pixel in the schema.
Pieces sample_schemas();

}  // namespace edgecase
