// SPDX-License-Identifier: MIT
//
// What a recording keeps of a case: a line as it comes from a renderer (reference/PROTOCOL.md), or
// the reason why there is none. The scene's digest stands in the recording's index.
#pragma once

#include <string>

#include "model/renderer.h"

namespace edgecase::recording {

// A line of JSON without a line break.
std::string stored_line(const Outcome& outcome);

// The inverse, as strict as answers are read; what is not an outcome of this scene is a Failure
// that says so.
Outcome outcome_of(const std::string& line, const Scene& scene);

}  // namespace edgecase::recording
