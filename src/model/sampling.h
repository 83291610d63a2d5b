// SPDX-License-Identifier: MIT
//
// Sampling: where the samples of a multisampled target lie, and how a draw makes use of them (GL
// 4.6 core, 14.3.1, 14.3.1.1 and 17.3).
#pragma once

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

}  // namespace edgecase
