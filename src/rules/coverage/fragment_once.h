// SPDX-License-Identifier: MIT
//
// One primitive of width or size 1 produces at most one fragment per pixel.
//
// The rules of points, lines and triangles (GL 4.6 core, 14.4 to 14.6) speak of the set of
// fragments of a primitive; a fragment that comes twice is blended twice.
#pragma once

#include "rules/rule.h"

namespace edgecase {

Rule fragment_once_rule();

}  // namespace edgecase
