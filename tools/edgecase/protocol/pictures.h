// SPDX-License-Identifier: MIT
//
// Properties of a picture that hold for any rasterizer: fragments lie within a pixel or two of
// their primitives, and pixels, fragments and numbers are consistent. Correctness is not tested.
#pragma once

#include <optional>
#include <string>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// Red, green and blue of a pixel as text.
std::string color_text(const Rendering& rendering, int x, int y);

// True if each component of the pixel is within `reach` of the colour's.
bool shows(const Rendering& rendering, int x, int y, const int (&color)[3], int reach);

// A fault and its remedy, both without full stop.
struct PictureFault {
  std::string finding;
  std::string remedy;
};

// For a scene whose primitives are white on black and each larger than a pixel: each has fragments,
// which lie where it does, and their pixels are not black.
std::optional<PictureFault> fault_of_drawing(const Scene& scene, const Rendering& rendering);

// Fragments have finite colours, and depths of 0 to 1.
std::optional<PictureFault> fault_of_values(const Rendering& rendering);

}  // namespace edgecase
