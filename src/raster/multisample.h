// SPDX-License-Identifier: MIT
//
// The exact rasterizer's multisampled path: fragments that stand for samples, and the planes of the
// samples that they are written to.
//
//   covered_samples -> one invocation per pixel, or per sample -> attributes where the rules have
//   them -> alpha to coverage -> planes -> resolved pixels
//
// It knows no textures: scenes that have both are not loaded.
#pragma once

#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "raster/attributes.h"
#include "rules/choices.h"

namespace edgecase {

// The exact alphas of a primitive at all samples of a pixel, covered or not, as a shader that runs
// for each sample has them.
std::vector<double> alphas_of_samples(const ScenePrimitive& primitive,
                                      const PrimitiveAttributes& attributes, PixelPosition pixel,
                                      const SamplePositions& positions,
                                      const LocationChoice& locations);

// Does a draw's alpha to coverage look at the alphas of other samples, its shader running for each?
bool heeds_others(const Multisampling& use, int samples, const SampleChoice& choice);

// Draws the primitive's fragments into a rendering whose sample positions are set and whose planes
// have been cleared. `details`: what is told of them; `coverage`: what covered_samples says.
void draw_multisampled(Rendering& rendering, const Target& target, const ScenePrimitive& primitive,
                       const RuleChoices& choices, Details details, const SampleCoverage& coverage);

// Fills the pixels from their samples.
void resolve_samples(Rendering& rendering, ResolveMethod method);

}  // namespace edgecase
