// SPDX-License-Identifier: MIT
//
// Blending of tests: the presets of case files, and what stands for their parts.
#pragma once

#include "model/fragment_operations.h"
#include "rules/output/blending.h"

namespace edgecase {

constexpr BlendTerm blend_term(BlendFactor source, BlendFactor destination) {
  return {BlendEquation::add, source, destination};
}

struct BlendPreset {
  const char* name;
  Blending blending;
};

inline const BlendPreset kBlendPresets[] = {
    {"over",
     {blend_term(BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha),
      blend_term(BlendFactor::one, BlendFactor::one_minus_src_alpha)}},
    {"premultiplied-over",
     {blend_term(BlendFactor::one, BlendFactor::one_minus_src_alpha),
      blend_term(BlendFactor::one, BlendFactor::one_minus_src_alpha)}},
    {"add",
     {blend_term(BlendFactor::one, BlendFactor::one),
      blend_term(BlendFactor::one, BlendFactor::one)}},
    {"multiply",
     {blend_term(BlendFactor::dst_color, BlendFactor::zero),
      blend_term(BlendFactor::dst_color, BlendFactor::zero)}}};

inline const Blending& over() {
  return kBlendPresets[0].blending;
}

inline FragmentOperations blending_by(const Blending& blending) {
  FragmentOperations operations;
  operations.blending = blending;
  return operations;
}

constexpr BlendFactor kBlendFactors[] = {BlendFactor::zero,
                                         BlendFactor::one,
                                         BlendFactor::src_color,
                                         BlendFactor::one_minus_src_color,
                                         BlendFactor::dst_color,
                                         BlendFactor::one_minus_dst_color,
                                         BlendFactor::src_alpha,
                                         BlendFactor::one_minus_src_alpha,
                                         BlendFactor::dst_alpha,
                                         BlendFactor::one_minus_dst_alpha,
                                         BlendFactor::constant_color,
                                         BlendFactor::one_minus_constant_color,
                                         BlendFactor::constant_alpha,
                                         BlendFactor::one_minus_constant_alpha,
                                         BlendFactor::src_alpha_saturate};
constexpr BlendEquation kBlendEquations[] = {BlendEquation::add, BlendEquation::subtract,
                                             BlendEquation::reverse_subtract, BlendEquation::min,
                                             BlendEquation::max};

inline std::uint8_t as_code(std::int64_t value) {
  return static_cast<std::uint8_t>(value);
}

}  // namespace edgecase
