// SPDX-License-Identifier: MIT
//
// The tests that a fragment passes on its way to the framebuffer: stencil, then depth.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "exact/interval.h"
#include "model/fragment_operations.h"
#include "model/scene.h"
#include "rules/rule.h"
#include "rules/values/framebuffer.h"

namespace edgecase {

// Essay: The stencil test
//
// The stencil test (GL 4.6 core, 17.3.3) compares the draw's reference with the stored value, both
// under a mask. The outcome selects an operation on the stored value. All values are integers, and
// nothing is open.
//
//   outcome                               the stored value becomes what
//   the test fails                        `fail` makes of it
//   it passes, and the depth test fails   `depth_fail` makes of it
//   both pass                             `pass` makes of it
//
// Only those bits of the new value that are in the write mask are stored.

Rule stencil_test_rule();  // stencil.test

enum class StencilMethod {
  as_set,
  ignored,       // no test, no operation
  one_sided,     // back-facing polygons are treated as front-facing ones
  unmasked,      // the comparison ignores its mask
  stored_first,  // the operands of the comparison are exchanged
  wrapping,      // incr and decr wrap
  saturating,    // incr_wrap and decr_wrap saturate
  write_mask_ignored,
  once_a_draw,  // of a draw, only the first fragment at a sample changes the stored value
};
template <>
inline constexpr auto kNames<StencilMethod> = std::to_array<TabledAlternative<StencilMethod>>(
    {{StencilMethod::as_set, "as-set", Openness::mandated,
      "the masked reference is compared with the masked stored value; the outcome's operation is "
      "carried out under the write mask"},
     {StencilMethod::ignored, "ignored", Openness::illegal,
      "there is no test, and stored values stay"},
     {StencilMethod::one_sided, "one-sided", Openness::illegal,
      "back-facing polygons are treated as front-facing ones"},
     {StencilMethod::unmasked, "unmasked", Openness::illegal, "the comparison uses no mask"},
     {StencilMethod::stored_first, "stored-first", Openness::illegal,
      "the stored value is compared with the reference, which exchanges less and greater"},
     {StencilMethod::wrapping, "wrapping", Openness::illegal,
      "incr and decr wrap, as incr_wrap and decr_wrap do"},
     {StencilMethod::saturating, "saturating", Openness::illegal,
      "incr_wrap and decr_wrap stop at 255 and 0, as incr and decr do"},
     {StencilMethod::write_mask_ignored, "write-mask-ignored", Openness::illegal,
      "operations change all bits, whatever the write mask says"},
     {StencilMethod::once_a_draw, "once-a-draw", Openness::illegal,
      "of the fragments of one draw at a sample, only the first changes the stored value"}});

// The state for fragments of one facing; points and lines are front-facing.
const StencilFace& face_of(const StencilTest& test, bool front_facing, StencilMethod method);

bool passes_stencil_test(const StencilFace& face, std::uint8_t stored, StencilMethod method);

// The stored value after an operation of a face, under its write mask.
std::uint8_t after(StencilOperation operation, const StencilFace& face, std::uint8_t stored,
                   StencilMethod method);

// Essay: The depth test
//
// The depth test (GL 4.6 core, 17.3.4) compares a fragment's depth with the stored one. The draw
// names the comparison. A fragment that fails it is discarded. A fragment that passes has its depth
// stored, unless the draw masks depths (17.4.2).
//
// The test compares values in the depth buffer's format. A fragment's depth is converted first
// (13.8.1, rules/values/framebuffer.h).

Rule depth_test_rule();  // depth.test
Rule depth_mask_rule();  // depth.mask
inline constexpr int kRulingOnUnconvertedDepth = 55;

enum class DepthTestMethod {
  as_set,
  unconverted,  // the fragment's depth is compared before it is converted
  ties_pass,    // less and greater let equal depths pass
  ties_fail,    // lequal and gequal reject equal depths
  ignored,      // every fragment passes
};
template <>
inline constexpr auto kNames<DepthTestMethod> = std::to_array<TabledAlternative<DepthTestMethod>>(
    {{DepthTestMethod::as_set, "as-set", Openness::mandated,
      "the fragment's depth, as the buffer would store it, is compared with the stored one"},
     {DepthTestMethod::unconverted, "unconverted", Openness::illegal,
      "the fragment's depth is compared before it is converted; the equal test may fail against a "
      "stored value of the same depth"},
     {DepthTestMethod::ties_pass, "ties-pass", Openness::illegal,
      "less and greater let equal depths pass"},
     {DepthTestMethod::ties_fail, "ties-fail", Openness::illegal,
      "lequal and gequal do not let equal depths pass"},
     {DepthTestMethod::ignored, "ignored", Openness::illegal, "every fragment passes"}});

// Whether a draw that masks depths stores any.
enum class DepthMaskMethod { as_set, ignored };
template <>
inline constexpr auto kNames<DepthMaskMethod> = std::to_array<TabledAlternative<DepthMaskMethod>>(
    {{DepthMaskMethod::as_set, "as-set", Openness::mandated,
      "draws that mask depths leave the stored depth as it is"},
     {DepthMaskMethod::ignored, "ignored", Openness::illegal,
      "the depth of every fragment that passes is stored"}});

// True if the depth of a fragment that passes is stored.
inline bool stores_depth(const DepthTest& test, DepthMaskMethod method) {
  return test.write || method == DepthMaskMethod::ignored;
}

// True if a fragment passes. `depth`: 0 to 1, before conversion; `stored`: a value of the format.
// Always true without a depth buffer.
bool passes_depth_test(const DepthTest& test, double depth, double stored, DepthFormat format,
                       DepthTestMethod method, DepthBits bits = DepthBits::as_set);

// The possible outcomes of a test; at least one.
struct TestOutcomes {
  bool may_pass = false;
  bool may_fail = false;
};

// For depths known as ranges of the format's values, both ends included. `same`: they are known to
// be one and the same number, whichever of the range it is.
TestOutcomes permitted_outcomes(CompareFunction function, Interval depth, Interval stored,
                                bool same);

// The same for a depth that is compared before conversion: `depth` is a range of numbers.
TestOutcomes unconverted_outcomes(CompareFunction function, Interval depth, Interval stored,
                                  DepthFormat format);

}  // namespace edgecase
