// SPDX-License-Identifier: MIT
//
// The author's hand-drawn truth against the exact side.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/case.h"
#include "model/rendering.h"

namespace edgecase {

// A drawing of hits per pixel, top row first, as case files have it: '.' none, '#' once, '2' to
// '9', '+' more.
std::string draw_hits(const std::vector<int>& hits, int width, int height);

// Hits per pixel of a rendering that counts them, row by row from the bottom: of each of its
// samples, in all passes of a supersampled one.
std::vector<int> hits_of(const Rendering& rendering);

// Which samples of each pixel are covered, row by row from the bottom: the union of its fragments'
// masks. `doubly`: those that two fragments cover.
struct PixelMasks {
  std::vector<std::uint32_t> covered;
  std::vector<std::uint32_t> doubly;
};
PixelMasks masks_of(const Rendering& rendering);

// A drawing of masks, top row first, as case files have it: cells in columns, hexadecimal digits or
// '.' for none.
std::string draw_masks(const std::vector<std::uint32_t>& masks, int width, int height);

// For each drawing made for `policy` that the exact rendering does not meet: where it stands, the
// first pixel that differs, and what exact draws.
std::vector<std::string> unmet_drawings(const Case& one, const std::string& policy,
                                        const Rendering& exact);

}  // namespace edgecase
