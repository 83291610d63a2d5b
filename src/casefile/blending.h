// SPDX-License-Identifier: MIT
//
// "blend" of a draw's state: a preset by its name, one term for all components, or a term for red,
// green and blue and one for alpha (GL 4.6 core, 17.3.6).
#pragma once

#include <array>

#include "casefile/fields.h"
#include "casefile/json_layout.h"
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

// Do the products play a part? `min` and `max` take colours without factors.
inline bool takes_factors(BlendEquation equation) {
  return equation != BlendEquation::min && equation != BlendEquation::max;
}

// What is faulty stays as Blending has it, and adds a finding.
Blending read_blending(const Place& place, Findings& findings);

// The inverse: the shortest form that says it.
JsonPiece blend_piece(const Blending& blending);

}  // namespace edgecase
