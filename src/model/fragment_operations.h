// SPDX-License-Identifier: MIT
//
// Fragment operations: what happens to a fragment between its shader and the framebuffer (GL 4.6
// core, 17.3), and the facing of polygons that some of it depends on (14.6.1 and 14.6.5).
//
//   fragment -> stencil test -> depth test -> blending -> colour mask -> target
//
// A state that was only default-constructed does what a context does that nobody has told anything
// else, with one exception: fragments are written to a depth buffer, without a test.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace edgecase {

// Of the depth test: does a fragment's depth compare so with the stored one? Of the stencil test:
// does the reference compare so with the stored value?
enum class CompareFunction { never, less, equal, lequal, greater, notequal, gequal, always };

// Depth values that a draw's fragments are held against, and write. GL_DEPTH_TEST disabled is
// {always, false}: without the test nothing is written.
struct DepthTest {
  CompareFunction function = CompareFunction::always;
  bool write = true;  // glDepthMask; only fragments that pass write
  friend bool operator==(const DepthTest&, const DepthTest&) = default;
};

// What becomes of a stored stencil value, before the write mask: `incr` and `decr` stop at 255 and
// 0, the others wrap.
enum class StencilOperation { keep, zero, replace, incr, incr_wrap, decr, decr_wrap, invert };

// The stencil test for polygons of one facing; points and lines are front-facing.
struct StencilFace {
  CompareFunction function = CompareFunction::always;
  std::uint8_t reference = 0;
  std::uint8_t read_mask = 0xff;                         // of both sides of the comparison
  std::uint8_t write_mask = 0xff;                        // glStencilMask
  StencilOperation fail = StencilOperation::keep;        // the stencil test fails
  StencilOperation depth_fail = StencilOperation::keep;  // it passes, and the depth test fails
  StencilOperation pass = StencilOperation::keep;        // both pass
  friend bool operator==(const StencilFace&, const StencilFace&) = default;
};

struct StencilTest {
  StencilFace front;
  StencilFace back;
  friend bool operator==(const StencilTest&, const StencilTest&) = default;
};

// Factors of blending (GL 4.6 core, table 17.2); the second source colour is left out.
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
// How the two products are put together (table 17.1); `min` and `max` take no factors.
enum class BlendEquation { add, subtract, reverse_subtract, min, max };

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

// Which way round the vertices of a front-facing polygon run in the window, y up.
enum class FrontFace { ccw, cw };
// Which polygons are dropped.
enum class CullMode { none, front, back, front_and_back };

// Added to the depth of each fragment of a polygon: factor m + units r, with m the depth's slope
// and r the smallest difference that the depth buffer resolves; where the clamp is not 0, no
// farther than it (GL 4.6 core, 14.6.5).
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

const char* name_of(CompareFunction);
const char* name_of(StencilOperation);
const char* name_of(BlendFactor);
const char* name_of(BlendEquation);
const char* name_of(FrontFace);
const char* name_of(CullMode);

// The inverse: false when `name` names none, `value` then untouched.
bool parse_name(const std::string& name, CompareFunction& value);
bool parse_name(const std::string& name, StencilOperation& value);
bool parse_name(const std::string& name, BlendFactor& value);
bool parse_name(const std::string& name, BlendEquation& value);
bool parse_name(const std::string& name, FrontFace& value);
bool parse_name(const std::string& name, CullMode& value);

// Does a comparison hold between a value and the stored one, given how they are ordered?
bool holds(CompareFunction function, bool less, bool equal);

}  // namespace edgecase
