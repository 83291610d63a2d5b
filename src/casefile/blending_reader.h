// SPDX-License-Identifier: MIT
//
// Reads "blend" of a draw's state: a preset by its name, one term for all components, or a term for
// red, green and blue and one for alpha (GL 4.6 core, 17.3.6).
#pragma once

#include "casefile/fields.h"
#include "model/fragment_operations.h"

namespace edgecase {

// What is faulty stays as Blending has it, and adds a finding.
Blending read_blending(const Place& place, Findings& findings);

}  // namespace edgecase
