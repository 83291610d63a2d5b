// SPDX-License-Identifier: MIT
//
// A primitive of width or size 1 produces at most one fragment per pixel.
//
// The rules for points, lines and triangles (GL 4.6 core, 14.4 to 14.6) define the set of a
// primitive's fragments. A set holds each fragment once. A fragment that is produced twice is
// blended twice.
#pragma once

#include "rules/rule.h"

namespace edgecase {

Rule fragment_once_rule();

}  // namespace edgecase
