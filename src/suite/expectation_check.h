// SPDX-License-Identifier: MIT
//
// Checks an author's hand-drawn expectations against the exact side.
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

// Hits per pixel of a rendering that counts them, row by row from the bottom: the sum over all
// samples and passes.
std::vector<int> hits_of(const Rendering& rendering);

// The covered samples of each pixel, row by row from the bottom: the union of its fragments' masks.
// `doubly`: samples that two fragments cover.
struct PixelMasks {
  std::vector<std::uint32_t> covered;
  std::vector<std::uint32_t> doubly;
};
PixelMasks masks_of(const Rendering& rendering);

// A drawing of masks, top row first, as case files have it: cells in columns, hexadecimal digits or
// '.' for none.
std::string draw_masks(const std::vector<std::uint32_t>& masks, int width, int height);

// For each drawing made for `policy` that differs from the exact rendering: its place in the file,
// the first pixel that differs, and exact's drawing.
std::vector<std::string> unmet_drawings(const Case& one, const std::string& policy,
                                        const Rendering& exact);

}  // namespace edgecase
