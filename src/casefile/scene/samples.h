// SPDX-License-Identifier: MIT
//
// Reads the samples of a target (their number and positions) and their use by a draw (GL 4.6 core,
// 14.3.1).
#pragma once

#include <string>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/scene/scene_reader.h"

namespace edgecase {

// The keys of a draw's state that read_multisampling reads.
std::vector<std::string> multisampling_keys();

// Reads "samples" and "sample_positions" of a target whose surface has been read. A faulty number
// of samples becomes 0, for unknown.
void read_samples(const ObjectReader& object, TargetFields& fields, Findings& findings);

// Reads the keys of a state on the use of samples. They are refused if the target's `samples` is 1;
// if it is 0, unknown, dependent checks are skipped.
Multisampling read_multisampling(const ObjectReader& state, int samples, Findings& findings);

// Reads supersampling: a pattern of points within a pixel and their weights
// (casefile/scene/patterns.h), or passes listed one by one.

// Reads "supersample" of a target whose samples have been read.
void read_supersample(const ObjectReader& object, TargetFields& fields, Findings& findings);

// Refuses a scene that would take too long: more than kMaxPassWork.
void check_pass_work(const Scene& scene, const TargetFields& fields, Findings& findings);

// Refuses drawings of coverage: each pass covers different pixels.
void check_no_drawing(const TargetFields& fields, const Place& drawing, Findings& findings);

// The definitions of "supersample" and of points within a pixel in the schema.
Pieces sample_schemas();

}  // namespace edgecase
