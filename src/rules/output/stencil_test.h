// SPDX-License-Identifier: MIT
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
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "model/fragment_operations.h"
#include "rules/rule.h"

namespace edgecase {

Rule stencil_test_rule();  // stencil.test

enum class StencilMethod {
  as_set,
  ignored,       // no test, no operation
  one_sided,     // back-facing polygons are treated as front-facing ones
  unmasked,      // the comparison ignores its mask
  stored_first,  // the operands of the comparison are exchanged
  wrapping,      // incr and decr wrap
  saturating,    // incr_wrap and decr_wrap saturate
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
      "incr_wrap and decr_wrap stop at 255 and 0, as incr and decr do"}});

// The state for fragments of one facing; points and lines are front-facing.
const StencilFace& face_of(const StencilTest& test, bool front_facing, StencilMethod method);

bool passes_stencil_test(const StencilFace& face, std::uint8_t stored, StencilMethod method);

// The stored value after an operation of a face, under its write mask.
std::uint8_t after(StencilOperation operation, const StencilFace& face, std::uint8_t stored,
                   StencilMethod method);

}  // namespace edgecase
