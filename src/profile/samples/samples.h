// SPDX-License-Identifier: MIT
//
// Multisampled targets: where samples lie, which primitives cover them, how often the shader runs,
// where it evaluates attributes, and how samples are written and resolved.
//
//   numbers of samples -> sweeps -> placement -> random triangles and lines -> GL_MULTISAMPLE,
//   sample mask -> invocations -> attributes, depths -> alpha to coverage -> resolve
//
// Answers for multisampled targets are whole and cost more than coverage alone, so random targets
// are smaller, and far fewer scenes are drawn than for single-sampled targets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "generate/grids.h"
#include "model/names.h"
#include "model/sampling.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "rules/choices.h"

namespace edgecase {

// Scenes about shading, writing and resolving the samples of a multisampled target, always a
// framebuffer object. Each depends only on its arguments. Vertices lie on multiples of 1/16 pixel,
// or of the steps of the sample positions, so that no snapping moves them.

constexpr int kPlainSize = 16;  // pixels, of the target of plane_scene

// A triangle, or a line of width 1, with red and green x/16 and y/16 and depth (x + 2 y)/64
// everywhere: a fragment's colour shows where in its pixel it was evaluated.
Scene plane_scene(std::uint64_t seed, PrimitiveKind kind, int samples, const Multisampling& use,
                  DepthFormat depth, std::uint64_t index);

// A way to request invocations of the shader.
struct InvocationsAsked {
  std::string name;  // "once", "share 0.25", "sample"
  Multisampling use;
};
// Without sample shading, and with shares of 0, 1/4, 1/2, 3/4 and 1, each for unqualified and for
// centroid attributes; and `sample`.
std::vector<InvocationsAsked> ways_to_ask_for_invocations();

// Alphas from 0 to 1: multiples of 1/256, and the float32 numbers next to the thresholds of the
// catalogue's alternatives. Sorted.
std::vector<float> probing_alphas(int samples);

// Alpha to coverage in fully covered pixels: pixel alpha_pixel(i) has the i-th of at most
// kAlphasPerScene alphas.
constexpr std::size_t kAlphasPerScene = 256;
Scene alpha_scene(int samples, std::span<const float> alphas);
PixelPosition alpha_pixel(std::size_t index);

// Alpha to coverage of a triangle with a constant alpha, or with one that changes within pixels and
// a shader that runs per sample.
Scene alpha_plane_scene(std::uint64_t seed, int samples, bool is_per_sample, std::uint64_t index);

// Every sample of every pixel has its own colour, written by means of the sample mask.
Scene resolve_scene(std::uint64_t seed, int samples, std::uint64_t index);

// The parts of a multisampled line's boundary.
enum class LineSide { start, end, left, right };  // left and right as seen from the start
template <>
inline constexpr auto kNames<LineSide> = std::to_array<Named<LineSide>>({{LineSide::start, "start"},
                                                                         {LineSide::end, "end"},
                                                                         {LineSide::left, "left"},
                                                                         {LineSide::right,
                                                                          "right"}});

// A line of width 1 with a sample exactly on a part of its boundary, but not at a corner.
struct LineSideProbe {
  Scene scene;
  PixelPosition pixel;
  std::size_t sample = 0;
  LineSide side = LineSide::start;
  LineDirection direction = LineDirection::right;
};
// Of every direction and part, except left and right sides of exact diagonals, which no dyadic
// sample lies on.
std::vector<LineSideProbe> line_side_probes(const SamplePositions& samples);

// ---------------------------------------------------------------------------------------- sweeps

// Sweeps move edges over a pixel in steps of 1/256 to find its sample positions.
//
// Each scene has one triangle with a vertical or horizontal edge, on its left, right, lower or
// upper side, that crosses the whole pixel. A sample that an edge at one position covers and an
// edge at the next does not lies between the two, at their positions after snapping.
constexpr int kSweepSteps = 256;  // per pixel

// The number of scenes of a sweep.
constexpr std::size_t kSweepScenes = 4 * (kSweepSteps + 1);

// The sweep for a target with this number of samples.
std::vector<Scene> sweep_scenes(int samples);

// The positions found by sweeps, observed in order. `snap`: how vertices are snapped.
MeasuredPositions measured_positions(std::span<const Observation> sweeps, Snap snap);

// ------------------------------------------------------------------------------------ invocations

InvocationRow empty_row(const InvocationsAsked& asked, int samples);

// Counts the fragments of a plane scene with one triangle: how often the shader runs per pixel and,
// by the colours, where it evaluates attributes.
void add_invocations(const Rendering& rendering, InvocationRow& row);

// ------------------------------------------------------------------------------------------ traits

// The part of a rendering that decides a rule.
enum class SampleEvidence {
  invocations,      // of each pixel
  colors,           // of each fragment of a plane scene
  fragment_depths,  // of each fragment of a plane scene
  sample_depths,    // of each sample that was written
  all_depths,       // both
  writes,           // how often each sample of each pixel was written
  switched_off,     // invocations, and depths of samples
};

// An alternative yields the evidence if the exact rasterizer under it, with everything else as
// found so far, has the same: a pixel's invocations, a colour or depth to within 1/64 pixel of its
// position, or the samples that a pixel's fragments write. `found`: the rules found so far.
Trait infer_sample_rule(const TraitId& id, SampleEvidence evidence,
                        std::span<const DrawnScene> scenes, const Choices& found);

// Whether attribute.smooth has the same alternative for multisampled lines as for those with one
// sample. Tries it together with attribute.location and takes what yields most colours.
Trait infer_line_parameter(std::span<const DrawnScene> lines, const Choices& found);

// sample.resolve, by the samples that the renderer reports.
Trait infer_resolve(std::span<const DrawnScene> scenes);

// Whether alpha to coverage keeps each sample by the alpha of its own invocation, for pixels whose
// shader runs per sample.
Trait own_alpha_trait(std::span<const DrawnScene> scenes, AlphaToCoverage choice);

// Masks by alpha, from alpha scenes with ascending alphas.
std::vector<AlphaRun> alpha_runs(std::span<const DrawnScene> scenes);

// Who owns samples on each part of a line's boundary.
OwnershipTable line_side_table(std::span<const LineSideProbe> probes,
                               std::span<const Observation> observations);
// The share of probes in which the choice and the renderer agree on the probed sample.
Trait line_side_trait(std::span<const LineSideProbe> probes,
                      std::span<const Observation> observations, const CoverageChoice& lines);

extern const Subject kSampleSubject;

}  // namespace edgecase
