// SPDX-License-Identifier: MIT
//
// Multisampled targets: where samples lie, which primitives cover them, how often the shader runs
// and where it has its attributes, and what becomes of the samples.
//
//   numbers of samples -> sweeps -> placement -> random triangles and lines -> GL_MULTISAMPLE,
//   sample mask -> invocations -> attributes, depths -> alpha to coverage -> resolve
//
// Answers about multisampled targets are whole, so they cost more than those of coverage alone:
// random targets are smaller, and far fewer scenes are drawn than of single-sampled targets.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "profile/evidence/findings.h"
#include "profile/samples/sample_scenes.h"
#include "rules/choices.h"

namespace edgecase {

// ---------------------------------------------------------------------------------------- sweeps

// Sweeps are edges that pass over a pixel in steps of 1/256, to find where its samples lie.
//
// Each scene has one triangle with a vertical or a horizontal edge, on its left, right, lower or
// upper side, that crosses the whole pixel. A sample that an edge at one position covers and an
// edge at the next does not lies between the two, where the edges are after they were snapped.
constexpr int kSweepSteps = 256;  // per pixel

// The number of scenes of a sweep.
constexpr std::size_t kSweepScenes = 4 * (kSweepSteps + 1);

// The sweep of a target with this number of samples.
std::vector<Scene> sweep_scenes(int samples);

// The positions that sweeps, observed in order, find. `snap`: how vertices are snapped.
MeasuredPositions measured_positions(std::span<const Observation> sweeps, Snap snap);

// ------------------------------------------------------------------------------------ invocations

InvocationRow empty_row(const InvocationsAsked& asked, int samples);

// Counts the fragments of a plane scene of one triangle: how often the shader runs for each pixel,
// and, by the colours, where it has its attributes.
void add_invocations(const Rendering& rendering, InvocationRow& row);

// ------------------------------------------------------------------------------------------ traits

// What of a rendering decides about a rule.
enum class SampleEvidence {
  invocations,      // of each pixel
  colors,           // of each fragment of a plane scene
  fragment_depths,  // of each fragment of a plane scene
  sample_depths,    // of each sample that was written
  all_depths,       // both
  writes,           // how often each sample of each pixel was written
  switched_off,     // invocations, and depths of samples
};

// An alternative yields the evidence where the exact rasterizer under it, everything else as found
// so far, has the same: a pixel's invocations, a colour or depth to within 1/64 pixel of where it
// was evaluated, the samples that a pixel's fragments write. `found`: the rules found so far.
Trait infer_sample_rule(const TraitId& id, SampleEvidence evidence,
                        std::span<const DrawnScene> scenes, const Choices& found);

// Does the rule attribute.smooth choose for multisampled lines as it does for those of one sample?
// The alternatives of it and of attribute.location that together yield most colours.
Trait infer_line_parameter(std::span<const DrawnScene> lines, const Choices& found);

// sample.resolve, by the samples that the renderer reports.
Trait infer_resolve(std::span<const DrawnScene> scenes);

// Does alpha to coverage keep each sample by the alpha of its own invocation? Of pixels of which
// the shader runs for each sample.
Trait own_alpha_trait(std::span<const DrawnScene> scenes, AlphaToCoverage choice);

// Masks by alpha, of alpha scenes whose alphas follow each other.
std::vector<AlphaRun> alpha_runs(std::span<const DrawnScene> scenes);

// Who owns samples on each part of a line's boundary.
OwnershipTable line_side_table(std::span<const LineSideProbe> probes,
                               std::span<const Observation> observations);
// In how many probes the choice covers the probed sample, or leaves it out, as the renderer does.
Trait line_side_trait(std::span<const LineSideProbe> probes,
                      std::span<const Observation> observations, const CoverageChoice& lines);

extern const Subject kSampleSubject;

}  // namespace edgecase
