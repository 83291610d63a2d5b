// SPDX-License-Identifier: MIT
//
// Sampling: where the samples of a multisampled target lie, and how a draw makes use of them (GL
// 4.6 core, 14.3.1, 14.3.1.1 and 17.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "exact/pixel.h"
#include "model/names.h"

namespace edgecase {

// Samples of a pixel at most; a coverage mask has a bit for each.
constexpr int kMaxSamples = 16;

// Positions of a pixel's samples, by sample index: pixels from its lower left corner, y up, 0 to
// below 1, multiples of 2^-16.
using SamplePositions = std::vector<Point>;

// What a primitive covers, by sample index: the pixels whose sample it covers, by row and column.
// As many lists as the target has samples; without multisampling, all but the first are empty.
using SampleCoverage = std::vector<std::vector<PixelPosition>>;

// The one sample of a pixel that is not multisampled.
inline Point centre_of_pixel() {
  return {Fixed::from_raw(Fixed::kOne / 2), Fixed::from_raw(Fixed::kOne / 2)};
}

// A place within a pixel, in the window.
Point place_in(PixelPosition pixel, Point within);

// Where the interpolated attributes of a fragment are evaluated: the qualifiers of GLSL 4.60,
// 4.5.2. `sample` also makes the shader run once for each sample.
enum class AttributeLocation {
  center,    // anywhere in the pixel
  centroid,  // anywhere in the pixel and the primitive
  sample,    // at the sample
};
template <>
inline constexpr auto kNames<AttributeLocation> =
    std::to_array<Named<AttributeLocation>>({{AttributeLocation::center, "center"},
                                             {AttributeLocation::centroid, "centroid"},
                                             {AttributeLocation::sample, "sample"}});

// How a draw uses the samples of a multisampled target. Of other targets nothing of it counts.
struct Multisampling {
  bool enabled = true;  // GL_MULTISAMPLE; without it every sample is covered as the centre is
  AttributeLocation location = AttributeLocation::center;
  // GL_SAMPLE_SHADING with glMinSampleShading: the share of samples, 0 to 1, that at least have an
  // invocation of their own. None: not enabled.
  std::optional<float> min_sample_shading;
  std::uint32_t mask = 0xffffffff;  // glSampleMaski: which samples may be written
  bool alpha_to_coverage = false;   // GL_SAMPLE_ALPHA_TO_COVERAGE

  friend bool operator==(const Multisampling&, const Multisampling&) = default;
};

// How many invocations of the shader a pixel that is wholly covered has at least: 1 to `samples`
// (GL 4.6 core, 14.3.1.1).
int least_invocations(const Multisampling& multisampling, int samples);

// Supersampling as courses teach it: a scene is shaded at several places of each pixel, and the
// pixel is their weighted mean,
//
//   image(x, y) = sum_k w_k shade(x + dx_k - 1/2, y + dy_k - 1/2) / sum_k w_k
//
// where shade(x, y) is what a target of one sample shows at the pixel whose centre is at (x + 1/2,
// y + 1/2). Each term is a pass: the scene drawn once, moved the other way, to a target of one
// sample. Nothing of it is known to OpenGL, which draws the passes.
struct Scene;
struct Vertex;
struct Viewport;

// Passes of a scene at most: a grid of 32 x 32.
constexpr std::size_t kMaxPasses = 1024;
constexpr std::int64_t kMaxPassWeight = std::int64_t{1} << 20;

struct ShadingPass {
  // Where in the pixel is shaded: pixels from its lower left corner, y up, multiples of 2^-16.
  // Kernels wider than a pixel reach beyond it: -1 to 2.
  Point at;
  // The weight's numerator; all weights of a scene are over their sum, which is exactly 1
  // therefore.
  std::int64_t weight = 1;  // more than 0, at most kMaxPassWeight

  friend bool operator==(const ShadingPass&, const ShadingPass&) = default;
};

// Empty: a scene that is not supersampled.
using Supersampling = std::vector<ShadingPass>;

// The pixels, the texels of generated textures and the vertices of a scene, times its passes, at
// most.
constexpr std::uint64_t kMaxPassWork = std::uint64_t{1} << 22;
std::uint64_t pass_work(const Scene& scene);

// How far the scene is moved for a pass, in pixels: from where it is shaded to the pixel's centre.
Point shift_of(const ShadingPass& pass);

// A vertex moved by that in a viewport. Of clip coordinates, x and y become the numbers nearest to
// x + 2 shift w / size that a ClipPosition can hold, ties to even; z and w stay. Not checked: does
// it lie where is_in_range wants it?
Vertex moved_vertex(const Vertex& vertex, Point shift, const Viewport& viewport);

// Window coordinates of at most Fixed::kMaxCoordinate, and clip coordinates of at most w.
bool is_in_range(const Vertex& vertex);

// What is drawn in pass k: the scene with all its vertices moved, and nothing else; not
// supersampled. Its rounded clip coordinates are the pass, for whoever draws it.
Scene pass_of(const Scene& scene, std::size_t k);

// "pass 3 of 9 (at 0.25, 0.75; weight 1)", of pass 2: people count from 1.
std::string words_of_pass(const Supersampling& passes, std::size_t k);

// All of them, in their order; none of a scene that is not supersampled.
std::vector<Scene> passes_of(const Scene& scene);

}  // namespace edgecase
