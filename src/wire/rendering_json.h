// SPDX-License-Identifier: MIT
//
// A rendering as written by `edgecase render --json`.
#pragma once

#include <string>

#include "model/rendering.h"

namespace edgecase {

// One object on one line, without a line break at its end: id, width, height, samples, fragments in
// the order of the rendering, pixels (RGBA8, row by row from the bottom), and, if present, sample
// positions, sample pixels, depths and stencils in the same order, mip chains, accumulated image
// and passes. Deterministic.
std::string rendering_json(const std::string& id, const Rendering& rendering);

// The array of the rendering's fragments as JSON text, without values that a fragment lacks (depth,
// colour, each detail). Numbers that are not finite become "nan", "inf" and "-inf".
std::string fragments_json(const Rendering& rendering);

// The array of the rendering's pixels as JSON text.
std::string pixels_json(const Rendering& rendering);

// The array of sample positions, [x, y] each; empty if they are not reported.
std::string sample_positions_json(const Rendering& rendering);

// The array of sample pixels, one plane per sample; empty if there are none.
std::string sample_pixels_json(const Rendering& rendering);

// The array of the depth buffer; empty if there is none.
std::string depths_json(const Rendering& rendering);

// The array of the stencil buffer; empty if there is none.
std::string stencils_json(const Rendering& rendering);

// The object of mip chains, arrays of levels by the texture's number; empty if there are none.
std::string mip_chains_json(const Rendering& rendering);

// The array of the accumulated image; empty if there is none.
std::string accumulated_json(const Rendering& rendering);

// The array of passes, each an object: pixels, fragments and, if present, depths, mip chains and
// hits.
std::string passes_json(const Rendering& rendering);

// The array of its hit counts.
std::string hits_json(const Rendering& rendering);

}  // namespace edgecase
