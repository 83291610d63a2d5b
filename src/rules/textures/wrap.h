// SPDX-License-Identifier: MIT
//
// Wrap modes choose the texel where coordinates leave the image (GL 4.6 core, 8.14.2, table 8.20).
// They act on whole texels, after the filter has chosen them:
//
//                    -2 -1  0  1  2  3  4  5    of an image of 4; b is the border
//   repeat            2  3  0  1  2  3  0  1
//   mirrored repeat   1  0  0  1  2  3  3  2
//   clamp to edge     0  0  0  1  2  3  3  3
//   clamp to border   b  b  0  1  2  3  b  b
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "model/texture.h"
#include "rules/rule.h"

namespace edgecase {

Rule wrap_rule();  // texture.wrap

enum class WrapChoice {
  as_set,
  mirrored_as_repeat,  // known from renderers without mirrored repetition
};
template <>
inline constexpr auto kNames<WrapChoice> = std::to_array<TabledAlternative<WrapChoice>>(
    {{WrapChoice::as_set, "as-set", Openness::mandated, "each axis wraps as its own mode says"},
     {WrapChoice::mirrored_as_repeat, "mirrored-as-repeat", Openness::illegal,
      "mirrored repetition repeats the image without mirroring it"}});

// The mode in effect when a mode is set.
Wrap effective(Wrap wrap, WrapChoice choice);

// The texel of 0 to size - 1 at `texel`, any 64-bit number; none: the border.
std::optional<int> wrapped(std::int64_t texel, int size, Wrap wrap, WrapChoice choice);

}  // namespace edgecase
