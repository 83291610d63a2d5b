// SPDX-License-Identifier: MIT
//
// Fragment operations in a draw's state and a target. First "blend" of a state: the name of a
// preset, one term for all components, or separate terms for colour and alpha (GL 4.6 core,
// 17.3.6).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/json/json_layout.h"
#include "casefile/scene/scene_reader.h"
#include "model/fragment_operations.h"

namespace edgecase {

// A named kind of blending; its constant colour is 0.
struct BlendPreset {
  const char* name;
  BlendTerm color;
  BlendTerm alpha;
};

// "over" is compositing as defined by Porter and Duff, for colours that are not, or are,
// premultiplied by alpha.
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

// Whether factors apply; `min` and `max` ignore them.
inline bool takes_factors(BlendEquation equation) {
  return equation != BlendEquation::min && equation != BlendEquation::max;
}

// Fragment operations of a draw's state: stencil and depth test, blending, colour mask, polygon
// offset (GL 4.6 core, 14.6 and 17.3), and the buffers of a target for them. Their forms are
// declared in casefile/scene/forms.h.

// The keys of a target that read_target_operations reads.
std::vector<std::string> target_operation_keys();

// Reads "stencil" and "depth_range" of a target whose other fields have been read. Refuses keys
// without their buffer.
void read_target_operations(const ObjectReader& object, TargetFields& fields, Findings& findings);

// Checks a draw that has been read for that target. Refuses a test without its buffer and, with
// supersampling, everything beyond overwriting fragments.
void check_fragment_operations(const ObjectReader& state, const TargetFields& target,
                               const Draw& draw, Findings& findings);

// Their definitions in the schema.
Pieces fragment_operation_schemas();

}  // namespace edgecase
