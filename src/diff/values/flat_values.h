// SPDX-License-Identifier: MIT
//
// Flat colours and texture coordinates (ruling 8): those of the provoking vertex, to the bit.
#pragma once

#include "diff/values/value_diff.h"

namespace edgecase {

// `fragment`: of a flat draw, with a colour, or with its texture coordinates in the colour's place.
// Adds a disagreement where it shows another vertex's, or what is no vertex's.
void compare_flat_color(const ValueContext& context, const Fragment& fragment, Result& result);

}  // namespace edgecase
