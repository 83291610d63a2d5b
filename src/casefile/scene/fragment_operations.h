// SPDX-License-Identifier: MIT
//
// What becomes of fragments, as a draw's state and a target say it. First "blend" of a state: a
// preset by its name, one term for all components, or a term for red, green and blue and one for
// alpha (GL 4.6 core, 17.3.6).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/json/json_layout.h"
#include "casefile/scene/scene_reader.h"
#include "model/fragment_operations.h"

namespace edgecase {

// A way of blending that a case file calls by name; its constant colour is 0.
struct BlendPreset {
  const char* name;
  BlendTerm color;
  BlendTerm alpha;
};

// "Over" is compositing as Porter and Duff have it, of colours that alpha has not been multiplied
// into, or has.
constexpr std::array<BlendPreset, 4> kBlendPresets{{
    {"over",
     {BlendEquation::add, BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha},
     {BlendEquation::add, BlendFactor::one, BlendFactor::one_minus_src_alpha}},
    {"premultiplied-over",
     {BlendEquation::add, BlendFactor::one, BlendFactor::one_minus_src_alpha},
     {BlendEquation::add, BlendFactor::one, BlendFactor::one_minus_src_alpha}},
    {"add",
     {BlendEquation::add, BlendFactor::one, BlendFactor::one},
     {BlendEquation::add, BlendFactor::one, BlendFactor::one}},
    {"multiply",
     {BlendEquation::add, BlendFactor::dst_color, BlendFactor::zero},
     {BlendEquation::add, BlendFactor::dst_color, BlendFactor::zero}},
}};

// A depth test that neither tests nor writes.
inline constexpr const char* kDepthOff = "off";

// Do the products play a part? `min` and `max` take colours without factors.
inline bool takes_factors(BlendEquation equation) {
  return equation != BlendEquation::min && equation != BlendEquation::max;
}

// What is faulty stays as Blending has it, and adds a finding.
Blending read_blending(const Place& place, Findings& findings);

// The inverse: the shortest form that says it.
JsonPiece blend_piece(const Blending& blending);

// What a draw's state says of what becomes of fragments: stencil and depth test, blending, colour
// mask, polygon offset (GL 4.6 core, 14.6 and 17.3), and what a target says of the buffers for it.

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

// Their definitions in the schema.
Pieces fragment_operation_schemas();

}  // namespace edgecase
