// SPDX-License-Identifier: MIT
//
// A rendering as `edgecase render --json` writes it.
#pragma once

#include <string>

#include "model/rendering.h"

namespace edgecase {

// One object on one line, without the line break at its end: id, width, height, samples, fragments
// in the order of the rendering, pixels (RGBA8, row by row from the bottom), and where the
// rendering has some, positions of samples, sample pixels, depths and stencils in the same order,
// mip chains, accumulated image and passes. Deterministic.
std::string rendering_json(const std::string& id, const Rendering& rendering);

// The array of the rendering's fragments as JSON text; what a fragment does not tell (depth,
// colour, each detail) is left out. Numbers that are not finite become "nan", "inf"
// and "-inf".
std::string fragments_json(const Rendering& rendering);

// The array of the rendering's pixels as JSON text.
std::string pixels_json(const Rendering& rendering);

// The array of where its samples lie, [x, y] each; empty where it says nothing of it.
std::string sample_positions_json(const Rendering& rendering);

// The array of the pixels of its samples, a plane for each; empty where it has none.
std::string sample_pixels_json(const Rendering& rendering);

// The array of its depth buffer; empty where it has none.
std::string depths_json(const Rendering& rendering);

// The array of its stencil buffer; empty where it has none.
std::string stencils_json(const Rendering& rendering);

// The object of its mip chains, arrays of levels by the texture's number; empty where it has none.
std::string mip_chains_json(const Rendering& rendering);

// The array of its accumulated image; empty where it has none.
std::string accumulated_json(const Rendering& rendering);

// The array of its passes, an object each: pixels, fragments and, where the pass has some, depths,
// mip chains and hits.
std::string passes_json(const Rendering& rendering);

// The array of its hit counts.
std::string hits_json(const Rendering& rendering);

}  // namespace edgecase
