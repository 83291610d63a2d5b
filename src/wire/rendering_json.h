// SPDX-License-Identifier: MIT
//
// A rendering as `edgecase render --json` writes it.
#pragma once

#include <string>

#include "model/rendering.h"

namespace edgecase {

// One object on one line, without the line break at its end: id, width, height, samples, fragments
// in the order of the rendering, and pixels (RGBA8, row by row from the bottom). Deterministic.
std::string rendering_json(const std::string& id, const Rendering& rendering);

// The array of the rendering's fragments as JSON text; what a fragment does not tell (depth,
// colour) is left out. Numbers that are not finite become "nan", "inf" and "-inf".
std::string fragments_json(const Rendering& rendering);

// The array of the rendering's pixels as JSON text.
std::string pixels_json(const Rendering& rendering);

}  // namespace edgecase
