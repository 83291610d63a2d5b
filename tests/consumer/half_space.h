// SPDX-License-Identifier: MIT
//
// The rasterizer under test: triangles by half-spaces in doubles, as many a course has it. It knows
// nothing of edgecase.
#pragma once

#include <array>
#include <vector>

struct PixelPlace {
  int x, y;  // y up
};

// The pixels of a width x height image whose centres lie in the triangle; a centre on an edge
// belongs to the triangle on its right, or below it.
std::vector<PixelPlace> half_space_pixels(const std::array<std::array<double, 2>, 3>& triangle,
                                          int width, int height);
