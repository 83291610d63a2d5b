// SPDX-License-Identifier: MIT
//
// Fragment operations: what happens to a fragment between its shader and the framebuffer (GL 4.6
// core, 17.3), and the facing of polygons that some of it depends on (14.6.1 and 14.6.5).
//
//   fragment -> stencil test -> depth test -> blending -> colour mask -> target
//
// A default-constructed state equals that of a fresh context, with one exception: fragments write
// the depth buffer, without a test.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "model/names.h"

namespace edgecase {

// The depth test compares a fragment's depth with the stored one; the stencil test compares the
// reference with the stored value.
enum class CompareFunction { never, less, equal, lequal, greater, notequal, gequal, always };
template <>
inline constexpr auto kNames<CompareFunction> =
    std::to_array<Named<CompareFunction>>({{CompareFunction::never, "never"},
                                           {CompareFunction::less, "less"},
                                           {CompareFunction::equal, "equal"},
                                           {CompareFunction::lequal, "lequal"},
                                           {CompareFunction::greater, "greater"},
                                           {CompareFunction::notequal, "notequal"},
                                           {CompareFunction::gequal, "gequal"},
                                           {CompareFunction::always, "always"}});

// The comparison with stored depths, and whether they are written. GL_DEPTH_TEST disabled is
// {always, false}: without the test nothing is written.
struct DepthTest {
  CompareFunction function = CompareFunction::always;
  bool write = true;  // glDepthMask; only fragments that pass write
  friend bool operator==(const DepthTest&, const DepthTest&) = default;
};

// The new stencil value, before the write mask: `incr` and `decr` stop at 255 and 0, the `_wrap`
// forms wrap.
enum class StencilOperation { keep, zero, replace, incr, incr_wrap, decr, decr_wrap, invert };
template <>
inline constexpr auto kNames<StencilOperation> =
    std::to_array<Named<StencilOperation>>({{StencilOperation::keep, "keep"},
                                            {StencilOperation::zero, "zero"},
                                            {StencilOperation::replace, "replace"},
                                            {StencilOperation::incr, "incr"},
                                            {StencilOperation::incr_wrap, "incr_wrap"},
                                            {StencilOperation::decr, "decr"},
                                            {StencilOperation::decr_wrap, "decr_wrap"},
                                            {StencilOperation::invert, "invert"}});

// The stencil test for polygons of one facing; points and lines are front-facing.
struct StencilFace {
  CompareFunction function = CompareFunction::always;
  std::uint8_t reference = 0;
  std::uint8_t read_mask = 0xff;                   // for both sides of the comparison
  std::uint8_t write_mask = 0xff;                  // glStencilMask
  StencilOperation fail = StencilOperation::keep;  // the stencil test fails
  StencilOperation depth_fail =
      StencilOperation::keep;                      // depth test fails after the stencil test passes
  StencilOperation pass = StencilOperation::keep;  // both pass
  friend bool operator==(const StencilFace&, const StencilFace&) = default;
};

struct StencilTest {
  StencilFace front;
  StencilFace back;
  friend bool operator==(const StencilTest&, const StencilTest&) = default;
};

// Factors of blending (GL 4.6 core, table 17.2), without those of a second source colour.
enum class BlendFactor {
  zero,
  one,
  src_color,
  one_minus_src_color,
  dst_color,
  one_minus_dst_color,
  src_alpha,
  one_minus_src_alpha,
  dst_alpha,
  one_minus_dst_alpha,
  constant_color,
  one_minus_constant_color,
  constant_alpha,
  one_minus_constant_alpha,
  src_alpha_saturate,
};
template <>
inline constexpr auto kNames<BlendFactor> = std::to_array<Named<BlendFactor>>(
    {{BlendFactor::zero, "zero"},
     {BlendFactor::one, "one"},
     {BlendFactor::src_color, "src_color"},
     {BlendFactor::one_minus_src_color, "one_minus_src_color"},
     {BlendFactor::dst_color, "dst_color"},
     {BlendFactor::one_minus_dst_color, "one_minus_dst_color"},
     {BlendFactor::src_alpha, "src_alpha"},
     {BlendFactor::one_minus_src_alpha, "one_minus_src_alpha"},
     {BlendFactor::dst_alpha, "dst_alpha"},
     {BlendFactor::one_minus_dst_alpha, "one_minus_dst_alpha"},
     {BlendFactor::constant_color, "constant_color"},
     {BlendFactor::one_minus_constant_color, "one_minus_constant_color"},
     {BlendFactor::constant_alpha, "constant_alpha"},
     {BlendFactor::one_minus_constant_alpha, "one_minus_constant_alpha"},
     {BlendFactor::src_alpha_saturate, "src_alpha_saturate"}});

// How the two products are combined (table 17.1); `min` and `max` ignore the factors.
enum class BlendEquation { add, subtract, reverse_subtract, min, max };
template <>
inline constexpr auto kNames<BlendEquation> =
    std::to_array<Named<BlendEquation>>({{BlendEquation::add, "add"},
                                         {BlendEquation::subtract, "subtract"},
                                         {BlendEquation::reverse_subtract, "reverse_subtract"},
                                         {BlendEquation::min, "min"},
                                         {BlendEquation::max, "max"}});

struct BlendTerm {
  BlendEquation equation = BlendEquation::add;
  BlendFactor source = BlendFactor::one;
  BlendFactor destination = BlendFactor::zero;
  friend bool operator==(const BlendTerm&, const BlendTerm&) = default;
};

struct Blending {
  BlendTerm color;  // red, green and blue
  BlendTerm alpha;
  std::array<float, 4> constant{0, 0, 0, 0};  // 0 to 1
  friend bool operator==(const Blending&, const Blending&) = default;
};

// In which direction the vertices of a front-facing polygon run in the window, y up.
enum class FrontFace { ccw, cw };
template <>
inline constexpr auto kNames<FrontFace> = std::to_array<Named<FrontFace>>({{FrontFace::ccw, "ccw"},
                                                                           {FrontFace::cw, "cw"}});

// Which triangles are discarded.
enum class CullMode { none, front, back, front_and_back };
template <>
inline constexpr auto kNames<CullMode> = std::to_array<Named<CullMode>>({{CullMode::none, "none"},
                                                                         {CullMode::front, "front"},
                                                                         {CullMode::back, "back"},
                                                                         {CullMode::front_and_back,
                                                                          "front_and_back"}});

// Added to the depth of each fragment of a polygon: factor m + units r, where m is the depth's
// slope and r the smallest difference that the depth buffer resolves; limited to the clamp, unless
// that is 0 (GL 4.6 core, 14.6.5).
struct PolygonOffset {
  float factor = 0;
  float units = 0;
  float clamp = 0;
  friend bool operator==(const PolygonOffset&, const PolygonOffset&) = default;
};

struct FragmentOperations {
  std::optional<StencilTest> stencil;
  DepthTest depth;
  std::optional<Blending> blending;
  std::array<bool, 4> color_mask{true, true, true, true};  // which components are written
  friend bool operator==(const FragmentOperations&, const FragmentOperations&) = default;
};

// Whether a comparison succeeds, given how the value is ordered against the stored one.
bool holds(CompareFunction function, bool less, bool equal);

}  // namespace edgecase
