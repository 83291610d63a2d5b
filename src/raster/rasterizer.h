// SPDX-License-Identifier: MIT
//
// The exact rasterizer's plain path: stages over the primitives of a scene, with each decision
// taken by the predicate of its rule. It uses no OpenGL and compares nothing.
//
//   primitives_of -> snap -> culling -> coverage (rules/coverage) -> attributes (rules/values)
//     -> textures (rules/textures) -> fragment operations (rules/output) -> pixels
//
// For coverage, kernels replace the predicates, with equal results, where they can
// (raster/coverage_stages.h). Callers that need pixels but no fragments use raster/framebuffer.h.
//
// raster/samples.h has the paths of multisampled targets and of supersampled scenes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/fixed.h"
#include "model/policy.h"
#include "model/renderer.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "raster/framebuffer.h"
#include "rules/choices.h"

namespace edgecase {

struct ExactLookup;
struct PrimitiveAttributes;

// The pixels that a draw can write: those of the target within the scissor rectangle. May be empty.
PixelBounds drawable_bounds(const Draw& draw, const Target& target);

// The pixels of the target that one primitive covers under a choice of rules, sorted by row, then
// column, ignoring multisampling. A culled primitive covers none.
std::vector<PixelPosition> covered_pixels(const ScenePrimitive& primitive, const Target& target,
                                          const CoverageChoice& choice);

// The same, restricted to a part of the target.
std::vector<PixelPosition> covered_pixels_within(const PixelBounds& part,
                                                 const ScenePrimitive& primitive,
                                                 const Target& target,
                                                 const CoverageChoice& choice);

// The point of the window at which a fragment of `pixel` takes its attributes if it does not take
// them at a sample: the pixel's centre, except in a wide line made of copies of the fragment in the
// middle of a column (of a row, if y-major). There it is the point at which the line, moved by -(w
// - 1)/2, has the column's lowest fragment: the preferred method of GL 4.6 core, 14.5.2.2.
// gl_FragCoord, depth and derivatives still belong to the pixel's own centre, as does everything of
// a pixel that the choice does not draw.
Point attribute_place(const ScenePrimitive& primitive, const Target& target,
                      const CoverageChoice& choice, PixelPosition pixel);

// The fragment at a pixel, with its attributes taken at attribute_place. In a textured draw
// `lookup` gives the colour; otherwise it is null.
Fragment shaded(const ScenePrimitive& primitive, const PrimitiveAttributes& attributes,
                const Target& target, const CoverageChoice& choice, PixelPosition pixel,
                const ExactLookup* lookup);

// The sample positions of a target's pixels under a choice of rules: `reported` by a renderer or,
// if that is empty, those of the case or the standard ones; shifted as the choice says. Just the
// centre if the target is not multisampled.
SamplePositions positions_of(const Target& target, const CoverageChoice& choice,
                             const SamplePositions& reported);

// How samples of a primitive are covered under a choice of rules: each by itself if GL_MULTISAMPLE
// is enabled, and otherwise as the choice says.
Unsampled sampling_of(const ScenePrimitive& primitive, const Target& target,
                      const CoverageChoice& choice);

// The samples, within the draw's sample mask, that one primitive covers under a choice of rules. If
// the pixel's centre decides for all samples, the result is that of a target with one sample: in
// list 0 alone, or in every list if the choice sets all coverage bits.
SampleCoverage covered_samples(const ScenePrimitive& primitive, const Target& target,
                               const CoverageChoice& choice, const SamplePositions& reported);

// The rendering that a policy's rules produce without rounding. `reported`: the sample positions
// that the compared renderer reports; empty if it reports none.
Rendering rasterize(const Scene& scene, const ResolvedPolicy& policy,
                    const SamplePositions& reported = {});

// The same with the further values that comparisons take from it: of textured draws coordinates and
// levels of detail, if the scene asks for them. A comparison derives the other ones itself.
Rendering rasterize_for_comparison(const Scene& scene, const ResolvedPolicy& policy,
                                   const SamplePositions& reported = {});

// The exact rasterizer behind the Renderer interface, under one policy, for `--against exact` and
// `render --with exact`. Comparisons call rasterize directly.

class ExactRenderer final : public Renderer {
 public:
  explicit ExactRenderer(const Policy& policy);
  const RendererInfo& info() const override { return info_; }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override;

 private:
  ResolvedPolicy policy_;
  RendererInfo info_;
};

// ExactDrawing: draws scenes repeatedly with the exact rasterizer. It uses the framebuffer where
// that can draw them, and the plain rasterizer otherwise.
class ExactDrawing {
 public:
  // `layers`: at least one scene, all of one target, drawn on top of each other; all but the first
  // cover the target. They must outlive the drawing. Vertices are prepared here, as OpenGL's are in
  // buffers.
  ExactDrawing(std::span<const Scene> layers, const ResolvedPolicy& policy);

  // Clears and draws all layers.
  void draw();

  // The result. For a single layer it equals Rendering::pixels of `rasterize`.
  std::vector<std::uint8_t> pixels() const;

 private:
  std::span<const Scene> layers_;
  const ResolvedPolicy policy_;
  Framebuffer framebuffer_;
  std::vector<FastScene> prepared_;  // of all layers, or empty
  std::vector<std::uint8_t> plain_pixels_;
};

}  // namespace edgecase
