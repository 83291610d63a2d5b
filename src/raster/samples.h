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

#include <functional>
#include <span>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "raster/attributes.h"
#include "rules/choices.h"
#include "rules/samples/accumulation.h"

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

// The exact rasterizer's supersampled path: each pass drawn by itself, then the weighted mean of
// what they show.
//
//   pass_of -> rasterize -> the last fragment of each pixel -> exact mean -> nearest double
//
// Under another choice of supersample.accumulation the last two steps are that one's.

// Draws one pass: a scene that is not supersampled.
using DrawPass = Rendering (*)(const Scene& scene, const ResolvedPolicy& policy,
                               const SamplePositions& reported);

// The rendering of a supersampled scene under a policy: passes, accumulated image, pixels.
Rendering draw_passes(const Scene& scene, const ResolvedPolicy& policy, DrawPass draw);

// What passes show, whoever drew them: one for each of the scene's, fragments sorted, all with a
// colour. Calls `visit` for each number of the accumulated image, in its order, with a value for
// each pass.
void for_each_shown(const Scene& scene, std::span<const Rendering> passes,
                    const std::function<void(std::span<const double>)>& visit);

// Rendering::accumulated of such passes.
std::vector<double> accumulated_image(const Scene& scene, std::span<const Rendering> passes,
                                      Accumulation choice = Accumulation::exact_mean);

}  // namespace edgecase
