// SPDX-License-Identifier: MIT
//
// Scenes of fragment operations for tests, and what they leave behind, as text.
#pragma once

#include <functional>
#include <string>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

constexpr Color kRed = {1, 0, 0, 1};
constexpr Color kGreen = {0, 1, 0, 1};
constexpr Color kBlue = {0, 0, 1, 1};
constexpr Color kWhite = {1, 1, 1, 1};

// A square target of opaque black with a depth and a stencil buffer, cleared to 1 and to 0.
Scene operation_scene(int size, DepthFormat depth = DepthFormat::depth24,
                      StencilFormat stencil = StencilFormat::stencil8);

// A rectangle of two counter-clockwise triangles, of whole pixels from (left, bottom) on, all of
// one window depth and one colour. No tests, no writing to the depth buffer.
Draw rectangle(Viewport area, double depth, const Color& color);
// The same with its triangles clockwise.
Draw turned_round(Draw rectangle);

// One character for each pixel, top row first; rows end in "/".
std::string grid(const Rendering& rendering, const std::function<char(std::size_t pixel)>& shown);
// Colours whose components are all 0 or 255, by their initials: "R", "G", "B", "W" and "C", "M",
// "Y", black ".", others "?".
std::string colors(const Rendering& rendering);
// 0 to 9, more "+".
std::string stencils(const Rendering& rendering);
std::string hits(const Rendering& rendering);
// Eighths, 8 for what is cleared to 1; others to the nearest.
std::string depths(const Rendering& rendering);

}  // namespace edgecase
