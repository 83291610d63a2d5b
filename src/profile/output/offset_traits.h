// SPDX-License-Identifier: MIT
//
// Offset traits: which slope and which unit a renderer's polygon offsets have.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "profile/output/output_profile.h"
#include "profile/profile.h"
#include "profile/scene_drawing.h"

namespace edgecase {

// How close to an alternative's depth a told one must be.
enum class OffsetPrecision {
  float_steps,  // what a handful of float32 operations yields, each rounded to nearest
  inexact,      // what ruling 9 permits of operations
};

// offset.slope, offset.unit or offset.exponent: the alternatives under which fragments have the
// depths that are told. `found`: the rules found so far.
Trait infer_offset(const std::string& rule, std::string id, OffsetPrecision precision,
                   std::span<const DrawnScene> told, const Choices& found);

// One unit, from triangles without a slope that are moved by enough units to tell it well: by
// format, and of a floating-point buffer by exponent.
std::vector<MeasuredUnit> measured_units(std::span<const DrawnScene> told);

}  // namespace edgecase
