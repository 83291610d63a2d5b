// SPDX-License-Identifier: MIT
//
// Properties of a picture that hold for any rasterizer: fragments lie within a pixel or two of
// their primitives, and pixels, fragments and numbers are consistent. Correctness is not tested.
#pragma once

#include <optional>
#include <string>

#include "model/rendering.h"
#include "model/scene.h"
#include "tools/edgecase/protocol/scenes.h"

namespace edgecase {

// Red, green and blue of a pixel as text.
std::string color_text(const Rendering& rendering, int x, int y);

// True if each component of the pixel is within `reach` of the colour's.
bool shows(const Rendering& rendering, int x, int y, const int (&color)[3], int reach);

// True if two pixels differ.
bool shows_contrast(const Rendering& rendering);

// A fault and its remedy, both without full stop.
struct Fault {
  std::string finding;
  std::string remedy;
};

// What a program should do that draws a scene otherwise than it asks.
constexpr const char* kRefuse =
    R"(answer {"digest": ..., "not_run": "a reason"} where a scene asks for what you do not do)";

// For a scene without draws: every pixel is clear, to the bit, and there are no fragments.
std::optional<Fault> fault_of_empty(const Scene& scene, const Rendering& rendering);

// The pixel that shows the feature has its colour.
std::optional<Fault> fault_of_feature(const FeatureScene& feature, const Rendering& rendering);

// True if the feature is no test, or a fragment that fails it is listed, or none at all is.
bool lists_failing(const FeatureScene& feature, const Rendering& rendering);

// For a scene whose primitives are white on black and each larger than a pixel: each has fragments,
// which lie where it does, and their pixels are not black.
std::optional<Fault> fault_of_drawing(const Scene& scene, const Rendering& rendering);

// Fragments have finite colours, and depths of 0 to 1.
std::optional<Fault> fault_of_values(const Rendering& rendering);

}  // namespace edgecase
