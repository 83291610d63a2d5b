// SPDX-License-Identifier: MIT
//
// The exact rasterizer, plain path: stages over the primitives of a scene, each decision taken by
// the predicate of its rule. It knows no OpenGL and compares nothing.
//
//   primitives_of -> snap -> culling -> coverage (rules/coverage) -> attributes (rules/values)
//     -> textures (rules/textures) -> fragment operations (rules/output) -> pixels
//
// Of coverage, kernels find what the predicates would, where they can (raster/coverage_stages.h).
// Who wants pixels and no fragments goes by raster/framebuffer.h.
//
// A multisampled target's path is in raster/samples.h, a supersampled scene's in
// raster/samples.h.
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "model/policy.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

struct ExactLookup;
struct PrimitiveAttributes;

// The pixels to which a draw can write: the target's, within the scissor rectangle. May be empty.
PixelBounds drawable_bounds(const Draw& draw, const Target& target);

// The pixels of the target that one primitive covers under a choice of rules, sorted by row,
// column: as without multisampling. None of one that is culled.
std::vector<PixelPosition> covered_pixels(const ScenePrimitive& primitive, const Target& target,
                                          const CoverageChoice& choice);

// The same of the pixels within a part of the target alone.
std::vector<PixelPosition> covered_pixels_within(const PixelBounds& part,
                                                 const ScenePrimitive& primitive,
                                                 const Target& target,
                                                 const CoverageChoice& choice);

// Where in the window a fragment of `pixel` takes its attributes where no sample has its own: in
// the pixel's centre, but of a wide line whose fragments are copies of one in the middle of its
// column (row, if y-major). There the line has what the line moved by -(w - 1)/2 has at the
// column's lowest fragment, which is the preferred method of GL 4.6 core, 14.5.2.2. gl_FragCoord,
// depth and derivatives are those of the pixel's own centre. So is all of a pixel that the choice
// does not draw.
Point attribute_place(const ScenePrimitive& primitive, const Target& target,
                      const CoverageChoice& choice, PixelPosition pixel);

// The fragment of such a pixel, its attributes taken there. `lookup`: of a textured draw, whose
// colour is what was looked up; else null.
Fragment shaded(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
                const Target& target, const CoverageChoice& choice, PixelPosition pixel,
                const ExactLookup* lookup);

// Where the samples of a target's pixels lie under a choice of rules: those that a renderer
// reports, or, where `reported` is empty, those of the case, or the standard ones; moved as the
// choice moves them. The centre alone where the target is not multisampled.
SamplePositions positions_of(const Target& target, const CoverageChoice& choice,
                             const SamplePositions& reported);

// How a primitive's samples are covered under a choice of rules: each by itself where
// GL_MULTISAMPLE is enabled, and otherwise as the choice has it.
Unsampled sampling_of(const ScenePrimitive& primitive, const Target& target,
                      const CoverageChoice& choice);

// What one primitive covers of the draw's sample mask under a choice of rules. Where the pixel's
// centre decides for all samples, what it covers as on a target of one sample, in list 0 alone, or
// in all of them where the coverage is to have all bits.
SampleCoverage covered_samples(const ScenePrimitive& primitive, const Target& target,
                               const CoverageChoice& choice, const SamplePositions& reported);

// The rendering that a policy's rules, applied without rounding, produce. `reported`: where the
// renderer that it is held against says that samples lie; empty: nobody says.
Rendering rasterize(const Scene& scene, const ResolvedPolicy& policy,
                    const SamplePositions& reported = {});

// The same, and nothing in Rendering::details, which may take four times the fragments' memory:
// a comparison derives the permitted details itself.
Rendering rasterize_without_details(const Scene& scene, const ResolvedPolicy& policy,
                                    const SamplePositions& reported = {});

}  // namespace edgecase
