// SPDX-License-Identifier: MIT
//
// Writes fragment operations and facing as a case file has them: the inverse of
// fragment_operations_reader.h. What equals the default is left out.
#pragma once

#include <vector>

#include "casefile/json_layout.h"
#include "model/scene.h"

namespace edgecase {

// Members of "target": stencil format, clear values and depth range.
std::vector<JsonPiece> target_operation_pieces(const Scene& scene);

// Members of a draw's "state".
std::vector<JsonPiece> fragment_operation_pieces(const Draw& draw);

}  // namespace edgecase
