// SPDX-License-Identifier: MIT
//
// Fragment operations: which codes a renderer stores for colours and depths, and how it blends,
// masks, tests and offsets.
//
//   plain colours, masks -> blending -> depth codes, depth test -> stencil test -> polygon offset
//     -> random scenes under all that was found
//
// Depth formats that a surface lacks are omitted, with a trait that says so.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "profile/evidence/findings.h"
#include "profile/evidence/tally.h"
#include "profile/output/output_scenes.h"
#include "rules/output/blending.h"

namespace edgecase {

// ------------------------------------------------------------------------------------------ codes

// How a number from 0 to 1 becomes an unsigned integer of some bits, for a colour or a depth
// buffer. The specification requires one of the two integers next to the number times 2^bits - 1
// (GL 4.6 core, 2.3.5.2; rulings 10 and 18), so this is no rule with alternatives of its own.
//
// Numbers beyond 0 to 1 are clamped first. With M = 2^bits - 1:
enum class CodeRounding {
  nearest,             // the code nearest to the exact product by M, ties to even
  nearest_of_float,    // the same for the product rounded to float32
  half_up_of_float,    // that product plus 1/2, added in float32, truncated
  truncated,           // the exact product by M, rounded down
  truncated_of_float,  // that product rounded to float32, then down
  up,                  // the exact product by M, rounded up
  power_nearest,       // the code nearest to the product by 2^bits, at most M
  power_truncated,     // the same product, rounded down
};
template <>
inline constexpr auto kNames<CodeRounding> =
    std::to_array<Named<CodeRounding>>({{CodeRounding::nearest, "nearest"},
                                        {CodeRounding::nearest_of_float, "nearest-of-float32"},
                                        {CodeRounding::half_up_of_float, "half-up-of-float32"},
                                        {CodeRounding::truncated, "truncate"},
                                        {CodeRounding::truncated_of_float, "truncate-of-float32"},
                                        {CodeRounding::up, "up"},
                                        {CodeRounding::power_nearest, "nearest-of-power"},
                                        {CodeRounding::power_truncated, "truncate-of-power"}});

// `value`: a float32 number. At most 24 bits.
long code_by(CodeRounding rounding, double value, int bits);

// Finds the rounding that yields all codes.
class CodeTally {
 public:
  CodeTally(std::string id, int bits);

  void add(double value, long code);
  Trait trait(TraitId id) const { return tally_.fitting(std::move(id)); }
  const CodeEvidence& evidence() const { return evidence_; }

 private:
  Tally tally_;
  CodeEvidence evidence_;
};

// ----------------------------------------------------------------------------------------- colours

// Adds the codes of plain colours.
void add_plain_colors(std::span<const DrawnScene> scenes, CodeTally& tally);

// Blending in cells: a triangle's colour meets the code that the first draw stored there.
//
// blend.equation: the alternatives under which the stored colour is permitted (ruling 37).
Trait infer_blend_method(std::span<const DrawnScene> scenes);
// blend.rounding: the alternatives that yield the stored colour, value by value.
Trait infer_blend_rounding(std::span<const DrawnScene> scenes, BlendMethod method);
// The differences of blended values from those of a choice.
std::vector<BlendResidual> blend_residuals(std::span<const DrawnScene> scenes,
                                           const BlendChoice& choice);

// -------------------------------------------------------------------------------- tests and
// offsets

// The trait of a rule from scenes of cells: the alternatives under which a pixel's triangles, with
// everything else as found so far, leave the observed colour and stencil value.
Trait infer_output_rule(RuleId rule, std::span<const DrawnScene> scenes, const Choices& found);

// The share of scenes in which fragments, hits, colours and stencil values are those of the rules
// found, in every pixel.
Trait output_agreement(TraitId id, std::span<const DrawnScene> scenes, const Choices& found);

// How close a fragment's depth must be to that of an alternative.
enum class OffsetPrecision {
  float_steps,  // results of a few float32 operations, each rounded to nearest
  inexact,      // what ruling 9 permits for operations
};

// offset.slope, offset.unit or offset.exponent: the alternatives that yield the fragments' depths.
// `found`: the rules found so far.
Trait infer_offset(const TraitId& id, OffsetPrecision precision, std::span<const DrawnScene> scenes,
                   const Choices& found);

// One unit, measured by triangles without a slope that are moved by many units: by format, and by
// exponent for a floating-point buffer.
std::vector<MeasuredUnit> measured_units(std::span<const DrawnScene> scenes);

extern const Subject kOutputSubject;

}  // namespace edgecase
