// SPDX-License-Identifier: MIT
//
// The exact rasterizer's multisampled path: fragments that stand for samples, and the sample planes
// that they write.
//
//   covered_samples -> one invocation per pixel, or per sample -> attributes where the rules have
//   them -> alpha to coverage -> planes -> resolved pixels
//
// It supports no textures: scenes with both are rejected on loading.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "raster/attributes.h"
#include "rules/choices.h"
#include "rules/samples/resolve.h"

namespace edgecase {

// The exact alphas of a primitive at all samples of a pixel, covered or not, for a shader that runs
// once per sample.
std::vector<double> alphas_of_samples(const ScenePrimitive& primitive,
                                      const PrimitiveAttributes& attributes, PixelPosition pixel,
                                      const SamplePositions& positions,
                                      const LocationChoice& locations);

// Whether alpha to coverage uses other samples' alphas although the shader runs per sample.
bool heeds_others(const Multisampling& use, int samples, const SampleChoice& choice);

// Draws the primitive's fragments into a rendering whose sample positions are set and whose planes
// are cleared. `stage`: the rendering's, one for all primitives. `details` to record; `coverage`
// from covered_samples.
void draw_multisampled(Rendering& rendering, const FragmentStage& stage, const Target& target,
                       const ScenePrimitive& primitive, const RuleChoices& choices, Details details,
                       const SampleCoverage& coverage);

// Computes the pixels from their samples.
void resolve_samples(Rendering& rendering, ResolveMethod method);

// The exact rasterizer's supersampled path: each pass drawn separately, then the weighted mean of
// what the passes show.
//
//   pass_of -> rasterize -> the last fragment of each pixel -> exact mean -> nearest double
//
// Another choice of supersample.accumulation replaces the last two steps.

// Draws one pass, a scene without supersampling.
using DrawPass = Rendering (*)(const Scene& scene, const ResolvedPolicy& policy,
                               const SamplePositions& reported);

// The rendering of a supersampled scene under a policy: passes, accumulated image, pixels.
Rendering draw_passes(const Scene& scene, const ResolvedPolicy& policy, DrawPass draw);

// Calls `visit` for each number of the accumulated image, in order, with one value for each pass.
// `passes` by any renderer: one for each of the scene's, with sorted fragments that all have a
// colour.
void for_each_shown(const Scene& scene, std::span<const Rendering> passes,
                    const std::function<void(std::span<const double>)>& visit);

// Rendering::accumulated for such passes.
std::vector<double> accumulated_image(const Scene& scene, std::span<const Rendering> passes,
                                      Accumulation choice = Accumulation::exact_mean);

}  // namespace edgecase
