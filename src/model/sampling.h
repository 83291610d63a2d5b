// SPDX-License-Identifier: MIT
//
// Sampling: the sample positions of a multisampled target, and how a draw uses samples (GL 4.6
// core, 14.3.1, 14.3.1.1 and 17.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "model/names.h"

namespace edgecase {

// The largest number of samples in a pixel; a coverage mask has a bit for each.
constexpr int kMaxSamples = 16;

// Positions of a pixel's samples, by sample index: pixels from its lower left corner, y up, from 0
// to below 1, multiples of 2^-16.
using SamplePositions = std::vector<Point>;

// The coverage of a primitive, by sample index: the pixels whose sample it covers, by row and
// column. There is one list per sample of the target; without multisampling only the first is used.
using SampleCoverage = std::vector<std::vector<PixelPosition>>;

// The single sample of a pixel without multisampling.
inline Point centre_of_pixel() {
  return {Fixed::from_raw(Fixed::kOne / 2), Fixed::from_raw(Fixed::kOne / 2)};
}

// The point of the window at `within` in a pixel.
Point place_in(PixelPosition pixel, Point within);

// Where the interpolated attributes of a fragment are evaluated: the qualifiers of GLSL 4.60,
// 4.5. `sample` also makes the shader run once for each sample.
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

// How a draw uses the samples of a multisampled target. Ignored for other targets.
struct Multisampling {
  bool enabled = true;  // GL_MULTISAMPLE; without it the centre decides for every sample
  AttributeLocation location = AttributeLocation::center;
  // GL_SAMPLE_SHADING with glMinSampleShading: the least share of samples, 0 to 1, with an
  // invocation of their own. None: not enabled.
  std::optional<float> min_sample_shading;
  std::uint32_t mask = 0xffffffff;  // glSampleMaski: which samples may be written
  bool alpha_to_coverage = false;   // GL_SAMPLE_ALPHA_TO_COVERAGE

  friend bool operator==(const Multisampling&, const Multisampling&) = default;
};

// The least number of shader invocations for a fully covered pixel: 1 to `samples` (GL 4.6 core,
// 14.3.1.1).
int least_invocations(const Multisampling& multisampling, int samples);

// Supersampling as taught in courses: a scene is shaded at several points of each pixel, and the
// pixel is their weighted mean,
//
//   image(x, y) = sum_k w_k shade(x + dx_k - 1/2, y + dy_k - 1/2) / sum_k w_k
//
// where shade(x, y) is what a target of one sample shows at the pixel whose centre is at (x + 1/2,
// y + 1/2). Each term is a pass: the scene drawn once, moved by the opposite offset, to a target of
// one sample. OpenGL only draws the passes.
struct Scene;
struct Vertex;
struct Viewport;

// The largest number of passes of a scene: a grid of 32 x 32.
constexpr std::size_t kMaxPasses = 1024;
constexpr std::int64_t kMaxPassWeight = std::int64_t{1} << 20;

struct ShadingPass {
  // The shaded point: pixels from the pixel's lower left corner, y up, multiples of 2^-16. Kernels
  // wider than a pixel reach beyond it: -1 to 2.
  Point at;
  // The weight's numerator. The denominator is the sum of all, so the weights add up to exactly 1.
  std::int64_t weight = 1;  // above 0, at most kMaxPassWeight

  friend bool operator==(const ShadingPass&, const ShadingPass&) = default;
};

// Empty if a scene is not supersampled.
using Supersampling = std::vector<ShadingPass>;

// The limit of pass_work: pixels, texels of generated textures and vertices, times the passes.
constexpr std::uint64_t kMaxPassWork = std::uint64_t{1} << 22;
std::uint64_t pass_work(const Scene& scene);

// How far the scene moves for a pass, in pixels: from the shaded point to the pixel's centre.
Point shift_of(const ShadingPass& pass);

// A vertex moved by `shift` in a viewport. For clip coordinates, x and y become the numbers nearest
// to x + 2 shift w / size that a ClipPosition can hold, ties to even; z and w stay. The result is
// not checked by is_in_range.
Vertex moved_vertex(const Vertex& vertex, Point shift, const Viewport& viewport);

// Whether window coordinates are at most Fixed::kMaxCoordinate, and clip coordinates at most w.
bool is_in_range(const Vertex& vertex);

// Pass k: the scene with all vertices moved, nothing else changed, not supersampled. Its clip
// coordinates, after rounding, define the pass for every renderer.
Scene pass_of(const Scene& scene, std::size_t k);

// "pass 3 of 9 (at 0.25, 0.75; weight 1)" for k = 2: people count from 1.
std::string text_of_pass(const Supersampling& passes, std::size_t k);

// All passes, in order; empty for a scene that is not supersampled.
std::vector<Scene> passes_of(const Scene& scene);

}  // namespace edgecase
