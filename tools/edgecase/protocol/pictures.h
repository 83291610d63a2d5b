// SPDX-License-Identifier: MIT
//
// What a picture shows, as far as any rasterizer must show it: where its fragments lie within a
// pixel or two, and that pixels, fragments and numbers go together. Whether it is right is not
// asked.
#pragma once

#include <optional>
#include <string>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// Red, green and blue of a pixel, in words.
std::string color_text(const Rendering& rendering, int x, int y);

// Does the pixel show the colour, each component to within `reach`?
bool shows(const Rendering& rendering, int x, int y, const int (&color)[3], int reach);

// What is wrong, and what to do about it; both without full stop.
struct PictureFault {
  std::string finding;
  std::string remedy;
};

// Of a scene whose primitives are larger than a pixel each, and white on black: each has fragments,
// they lie where it does, and their pixels are not black.
std::optional<PictureFault> fault_of_drawing(const Scene& scene, const Rendering& rendering);

// Fragments have finite colours, and depths of 0 to 1.
std::optional<PictureFault> fault_of_values(const Rendering& rendering);

}  // namespace edgecase
