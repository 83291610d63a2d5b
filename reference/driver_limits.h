// SPDX-License-Identifier: MIT
//
// What a driver can draw, by its own word or by trying, and what of a scene is beyond it. A driver
// would draw such a scene otherwise than asked, without an error.
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
  std::array<float, 2> sampled_line_widths{1, 1};  // the same of multisampled lines
  std::array<float, 2> point_sizes{1, 1};          // likewise
  // How far supported ones lie apart; 0: the API does not say, and all are supported.
  float sampled_line_width_step = 0;
  float point_size_step = 0;
  float texture_lod_bias = 2;                 // the least that OpenGL allows
  float anisotropy = 1;                       // 1: there is no anisotropic filtering
  std::array<bool, 2> provoking{true, true};  // by ProvokingVertex: setting it has its effect
  std::vector<int> sample_counts;             // of multisampled targets; empty: there are none
  bool places_samples = false;                // where a case asks for them
  bool clamps_polygon_offset = false;
  bool saturates_destinations = false;  // src_alpha_saturate may be the destination's factor
  std::optional<EsFeatures> es;         // of a context of OpenGL ES; none: it is one of OpenGL
};

// What the context says of itself; what is found by trying is left as it is.
DriverLimits stated_limits(const GladGLContext& gl);

// What a driver with these limits cannot draw, as a sentence; empty: it can draw all.
std::string limit_exceeded_by(const Scene& scene, const DriverLimits& limits);

// "1 to 255"
std::string text_of_range(const std::array<float, 2>& range);
// "1 by 0.125": the smallest, and how far supported ones lie apart.
std::string text_of_steps(const std::array<float, 2>& range, float step);

}  // namespace edgecase
