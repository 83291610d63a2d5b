// SPDX-License-Identifier: MIT
//
// Observation: what a renderer was seen to draw of generated scenes. Coverage alone, unless a
// question is about colours; of multisampled targets, what each sample was covered by.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "model/renderer.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// A scene with what was drawn of each of its primitives. Does not move: others point into `scene`.
struct Observation {
  std::string id;  // "triangle/000123", for counter-examples
  Scene scene;
  std::vector<std::vector<PixelPosition>> drawn;  // by primitive, row first, as often as it came
  // Of a multisampled target, in the place of `drawn`: by primitive, the same of each sample.
  std::vector<SampleCoverage> samples;
  SamplePositions positions;  // where the renderer says that they lie
  std::string failure;        // why there is no rendering; empty: there is one
};

// A new renderer of the one that is measured: each surface is measured with its own.
using MakeRenderer = std::function<std::unique_ptr<Renderer>()>;

// What the fragments of a rendering cover of a multisampled target, by primitive and sample.
std::vector<SampleCoverage> covered_by_fragments(const Scene& scene, const Rendering& rendering);

// Is the observed coverage of a primitive what the choice draws? There must be no failure.
bool is_drawn_by(const CoverageChoice& choice, const ScenePrimitive& primitive,
                 const Observation& observation);

// Called with the number of scenes that were drawn since the last call; from any thread.
using ObservationProgress = std::function<void(std::size_t)>;

// Thrown when `stop` became true.
struct MeasurementStopped {};

// Renders every scene for its coverage and fills `drawn` or `failure`.
void observe(Renderer& renderer, std::span<Observation> observations,
             const ObservationProgress& progress, const std::atomic<bool>* stop);

// The whole renderings, in order, for questions about colours.
std::vector<Outcome> render_all(Renderer& renderer, std::span<const Scene> scenes,
                                const std::atomic<bool>* stop);

}  // namespace edgecase
