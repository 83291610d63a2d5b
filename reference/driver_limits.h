// SPDX-License-Identifier: MIT
//
// The limits of a driver, as reported or found by experiment, and which scenes exceed them. A
// driver would draw such a scene differently from the request, without an error.
#pragma once

#include <glad/gl.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/scene.h"
#include "reference/es_limits.h"

namespace edgecase {

struct DriverLimits {
  int size = 0;                                    // of a target, pixels along either side
  std::array<GLint, 2> viewport{0, 0};             // width and height, pixels
  std::array<float, 2> line_widths{1, 1};          // smallest and largest, pixels
  std::array<float, 2> sampled_line_widths{1, 1};  // the same for multisampled lines
  std::array<float, 2> point_sizes{1, 1};          // likewise
  // The distance between supported values; 0: not reported, and all are supported.
  float sampled_line_width_step = 0;
  float point_size_step = 0;
  float texture_lod_bias = 2;                 // the least that OpenGL allows
  float anisotropy = 1;                       // 1: no anisotropic filtering
  std::array<bool, 2> provoking{true, true};  // by ProvokingVertex: setting it works
  std::vector<int> sample_counts;             // of multisampled targets; empty: there are none
  bool places_samples = false;                // at positions requested by a case
  bool tells_samples = true;                  // gl_SampleMaskIn, and the qualifier sample
  bool shades_samples = true;                 // glMinSampleShading
  // Stencils of multisampled targets can be fetched: with a depth buffer, and alone.
  bool fetches_packed_stencils = true;
  bool fetches_stencils = true;
  // Found by experiment, of a context without storage blocks, where nothing is left out of what a
  // scene requests: textureQueryLod, and fine and coarse derivatives.
  bool writes_storage = true;
  bool queries_level_of_detail = true;
  bool derives_fine_and_coarse = true;
  bool clamps_polygon_offset = false;
  bool saturates_destinations = false;  // by src_alpha_saturate
  std::optional<EsFeatures> es;         // of an OpenGL ES context; nothing for OpenGL
};

// The limits that the context reports; those found by experiment are left unset.
DriverLimits stated_limits(const GladGLContext& gl);

// What a driver with these limits cannot draw, as a sentence; empty if it can draw everything.
std::string limit_exceeded_by(const Scene& scene, const DriverLimits& limits);

// "1 to 255"
std::string text_of_range(const std::array<float, 2>& range);
// "1 by 0.125": the smallest value, and the distance between supported ones.
std::string text_of_steps(const std::array<float, 2>& range, float step);

}  // namespace edgecase
