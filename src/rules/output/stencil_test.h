// SPDX-License-Identifier: MIT
//
// The stencil test (GL 4.6 core, 17.3.3): the draw's reference against what is stored, both under a
// mask; and what becomes of the stored value. All of it is integers: nothing is open.
//
//   the test fails                      the value becomes what `fail` makes of it
//   it passes, and the depth test fails what `depth_fail` makes of it
//   both pass                           what `pass` makes of it
//
// Of the new value only bits of the write mask are stored.
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
