// SPDX-License-Identifier: MIT
//
// Reads what a case file says of supersampling: a pattern of places within a pixel, and how much
// each of them counts (casefile/shading_patterns.h); or the passes one by one.
#pragma once

#include "casefile/fields.h"
#include "casefile/scene_reader.h"

namespace edgecase {

// "supersample" of a target whose samples have been read.
void read_supersample(const ObjectReader& object, TargetFields& fields, Findings& findings);

// Refuses a scene that would take too long: more than kMaxPassWork.
void check_pass_work(const Scene& scene, const TargetFields& fields, Findings& findings);

// Refuses drawings of coverage: each pass covers pixels of its own.
void check_no_drawing(const TargetFields& fields, const Place& drawing, Findings& findings);

}  // namespace edgecase
