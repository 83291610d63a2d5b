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

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "exact/fixed.h"
#include "generate/random_scenes.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "profile/evidence/inference.h"
#include "rules/output/blending.h"

namespace edgecase {

// Scenes about fragment operations: depths, stencil values and colours.
//
// A cell is a pixel with its own triangles round its centre, strictly inside it, with vertices at
// multiples of 1/4 pixel: neither snapping nor ties matter, and each triangle makes one fragment.
// Every triangle has one colour and, except in offset scenes with a slope, one depth. Each scene
// depends only on its arguments.

constexpr int kCellColumns = 16;  // of a scene; also rows
constexpr std::size_t kCells = std::size_t{kCellColumns} * kCellColumns;

// Formats of depth buffers, without none.
inline constexpr std::array kDepthFormats{DepthFormat::depth16, DepthFormat::depth24,
                                          DepthFormat::depth32f};

// ---------------------------------------------------------------------------------------- colours

// Plain colours: the float32 numbers next to every border between two codes, multiples of 1/256,
// and numbers beyond 0 to 1.
std::vector<Scene> plain_color_scenes(Surface surface);

// Every set of masked components, over codes of every kind.
std::vector<Scene> color_mask_scenes(std::uint64_t seed, Surface surface);

// Codes blended with random colours, half of which are codes, too: every equation with every pair
// of factors, and for the over operator every alpha with every fourth code. Alpha has a separate
// term. Scenes with the same factor of the destination are consecutive.
std::vector<Scene> blend_scenes(std::uint64_t seed, Surface surface);

// ----------------------------------------------------------------------------------------- depths

// Depths swept over all codes, close to borders between two of them and to whole ones.
std::vector<Scene> depth_code_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// Every function of the depth test between depths that are equal, or differ by more than any
// rounding. They lie below the middle between two codes, where rounding to nearest and truncating
// give the same.
std::vector<Scene> depth_test_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// Every function and operation of the stencil test on triangles of either facing, with masks, and
// stored values from 0 to 255. With a depth buffer the depth test passes and fails, too.
std::vector<Scene> stencil_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// ----------------------------------------------------------------------------------------- offset

// Only units: enough to distinguish one step of a fixed-point buffer from 2^-n; for floating-point
// buffers over depths of many exponents.
std::vector<Scene> offset_unit_scenes(Surface surface, DepthFormat format);

// Only factors, on depths that rise by different amounts in x and in y.
std::vector<Scene> offset_slope_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// ------------------------------------------------------------------------------------------ cells

// Window depths of 0 to 1 are multiples of 2^-17, since z is a multiple of 2^-16.
constexpr std::int64_t kDepthOne = 2 * Fixed::kOne;
constexpr Fixed z_of_depth(std::int64_t depth) {
  return Fixed::from_raw(depth - Fixed::kOne);
}

// Generators of one seed with different purposes are independent.
enum class OutputStream : std::uint64_t { masks = 0x5d00, blends, codes, tests, stencils, slopes };
RandomSource random_of(std::uint64_t seed, OutputStream stream, Surface surface,
                       std::uint64_t index);

// An empty target of cells.
Scene cell_scene(Surface surface);

// A draw of triangles, without vertices yet.
Draw cell_draw();

// One triangle in the pixel of a cell, counter-clockwise if front-facing, with its corners at (1/4,
// 1/4), (3/4, 1/4) and (1/2, 3/4), so that the pixel's centre halves its height.
struct CellTriangle {
  Color color{1, 1, 1, 1};
  std::array<Fixed, 3> z{};  // of the corners
  bool front_facing = true;
};
void add_triangle(Draw& draw, std::size_t cell, const CellTriangle& triangle);

// Of one depth, a multiple of 2^-17.
CellTriangle flat_triangle(const Color& color, std::int64_t depth, bool front_facing = true);

// The pixel that contains a triangle.
PixelPosition cell_pixel(const ScenePrimitive& primitive);

// The float32 nearest to an 8-bit colour value.
float code_color(std::int64_t code);
Color random_codes(RandomSource& random);

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
