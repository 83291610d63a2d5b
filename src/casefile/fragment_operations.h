// SPDX-License-Identifier: MIT
//
// What a draw's state says of what becomes of fragments: stencil and depth test, blending, colour
// mask, polygon offset (GL 4.6 core, 14.6 and 17.3), and what a target says of the buffers for it.
#pragma once

#include <string>
#include <vector>

#include "casefile/fields.h"
#include "casefile/json_layout.h"
#include "casefile/scene_reader.h"

namespace edgecase {

// The keys of a target that read_target_operations reads.
std::vector<std::string> target_operation_keys();

// "stencil" and "depth_range" of a target whose other fields have been read. What stands without
// its buffer is refused.
void read_target_operations(const ObjectReader& object, TargetFields& fields, Findings& findings);

// The keys of a draw's state that read_fragment_operations reads.
std::vector<std::string> fragment_operation_keys();

// Into a draw of that target. A test without its buffer is refused, as is, beside supersampling,
// all that is more than writing one fragment over the other.
void read_fragment_operations(const ObjectReader& state, const TargetFields& target, Draw& draw,
                              Findings& findings);

// The inverse: members of a draw's "state". What equals the default is left out.
std::vector<JsonPiece> fragment_operation_pieces(const Draw& draw);

}  // namespace edgecase
