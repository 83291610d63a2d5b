// SPDX-License-Identifier: MIT
//
// Reads `expect`: the author's drawings of which pixels are hit, in the case file or beside it,
// or which samples are covered.
//
// Drawings are written as people see them, top row first, and stored bottom row first, since window
// coordinates have y up. A drawing in a file of its own must lie inside the case's folder, whatever
// links and ".." say.
#pragma once

#include <filesystem>

#include "casefile/fields.h"
#include "model/case.h"
#include "model/scene.h"

namespace edgecase {

// One item of `expect`. `target` gives the wanted size and the number of samples; what is 0 is not
// known, and not checked. `folder` is the case file's. Which cases it holds for, its "when", is
// read by casefile/expect_when.h.
Expect read_drawing(const Place& place, const Target& target, const std::filesystem::path& folder,
                    Findings& findings);

}  // namespace edgecase
