// SPDX-License-Identifier: MIT
//
// The ways of blending that a case file calls by name; their constant colour is 0.
#pragma once

#include <array>

#include "model/fragment_operations.h"

namespace edgecase {

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

}  // namespace edgecase
