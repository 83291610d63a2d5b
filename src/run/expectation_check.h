// SPDX-License-Identifier: MIT
//
// The author's hand-drawn truth against the exact side.
#pragma once

#include <string>
#include <vector>

#include "model/case.h"
#include "model/rendering.h"

namespace edgecase {

// A drawing of hits per pixel, top row first, as case files have it: '.' none, '#' once, '2' to
// '9'.
std::string draw_hits(const std::vector<int>& hits, int width, int height);

// Hits per pixel of a rendering, row by row from the bottom.
std::vector<int> hits_of(const Rendering& rendering);

// For each drawing made for `policy` that the exact rendering does not meet: where it stands, the
// first pixel that differs, and what exact draws.
std::vector<std::string> unmet_drawings(const Case& one, const std::string& policy,
                                        const Rendering& exact);

}  // namespace edgecase
