// SPDX-License-Identifier: MIT
//
// Scenes about shading, writing and resolving the samples of a multisampled target, always a
// framebuffer object. Each depends only on its arguments. Vertices lie on multiples of 1/16 pixel,
// or of the steps of the sample positions, so that no snapping moves them.
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

namespace edgecase {

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

}  // namespace edgecase
