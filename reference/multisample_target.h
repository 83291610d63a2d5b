// SPDX-License-Identifier: MIT
//
// Multisampled framebuffers: textures, whose samples can be fetched, and single-sampled images into
// which they are resolved and fetched.
//
// A driver may make more samples than requested (GL 4.6 core, 8.8), which would give another
// picture and is refused. All pixels of a texture have the same sample positions ("fixed sample
// locations"), which the driver reports by GL_SAMPLE_POSITION. Positions from a case need
// GL_ARB_sample_locations.
#pragma once

#include <string>
#include <vector>

#include "model/scene.h"
#include "reference/gl_objects.h"

namespace edgecase {

// Framebuffers and images of width x height pixels.
struct MultisampleTarget {
  int width = 0;
  int height = 0;
  int samples = 0;
  DepthFormat depth = DepthFormat::none;
  StencilFormat stencil = StencilFormat::none;
  SamplePositions placed;     // the case's sample positions; empty: it gives none
  SamplePositions positions;  // as reported by the driver
  GlTexture depth_image;      // depths and stencils, of both framebuffers; absent without either
  GlTexture color_image;      // RGBA8
  GlFramebuffer color;
  GlTexture count_image;  // R32F
  GlFramebuffer count;
  // Single-sampled, RGBA8.
  GlRenderbuffer resolved_image;
  GlFramebuffer resolved;
  // Single-sampled, as wide as the target and `planes` times as high, RGBA8 and R32F.
  int planes = 0;
  GlRenderbuffer color_planes_image;
  GlFramebuffer color_planes;
  GlRenderbuffer float_planes_image;
  GlFramebuffer float_planes;
};

// The numbers of samples, more than one, that the driver supports exactly, found by trying 2, 4, 8
// and 16. Leaves no error.
std::vector<int> find_sample_counts(const GladGLContext& gl);

// Whether a case can place the samples of a framebuffer.
bool can_place_samples(const GladGLContext& gl);

// Whether it was made for a target like this one.
bool fits(const MultisampleTarget& made, const Target& target);

// Makes the framebuffers for a target of more than one sample. Returns why the driver does not
// support them, as a sentence; empty on success.
std::string make_multisample_target(const GladGLContext& gl, const Target& target,
                                    MultisampleTarget& made);

}  // namespace edgecase
