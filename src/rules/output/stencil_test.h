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
  unmasked,      // the comparison does without its mask
  stored_first,  // the stored value is compared with the reference, not the reference with it
  wrapping,      // incr and decr wrap
  saturating,    // incr_wrap and decr_wrap do not
};
std::span<const StencilMethod> all_stencil_methods();
const char* name_of(StencilMethod choice);
bool parse_name(std::string_view name, StencilMethod& choice);

// What the test does to fragments of one facing; points and lines are front-facing.
const StencilFace& face_of(const StencilTest& test, bool front_facing, StencilMethod method);

bool passes_stencil_test(const StencilFace& face, std::uint8_t stored, StencilMethod method);

// The stored value after an operation of a face, under its write mask.
std::uint8_t after(StencilOperation operation, const StencilFace& face, std::uint8_t stored,
                   StencilMethod method);

}  // namespace edgecase
