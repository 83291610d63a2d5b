// SPDX-License-Identifier: MIT
//
// Multisampled framebuffers: textures, so that their samples can be fetched, and single-sampled
// images into which they are resolved and fetched.
//
// A driver is free to make more samples than it is asked for (GL 4.6 core, 8.8), and another number
// of samples is another picture: it is refused. All pixels of a texture have their samples in the
// same places ("fixed sample locations"), which the driver reports by GL_SAMPLE_POSITION. A case's
// own places need GL_ARB_sample_locations.
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
  SamplePositions placed;     // where the case puts the samples; empty: it does not
  SamplePositions positions;  // as the driver reports them
  GlTexture depth_image;      // depths and stencils, of both framebuffers; none without either
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

// The numbers of samples, more than one, that the driver makes when it is asked for them: by trying
// 2, 4, 8 and 16. Leaves no error.
std::vector<int> find_sample_counts(const GladGLContext& gl);

// Can a case place the samples of a framebuffer?
bool can_place_samples(const GladGLContext& gl);

// Was it made for a target like this one?
bool fits(const MultisampleTarget& made, const Target& target);

// Makes the framebuffers for a target of more than one sample. Returns why the driver cannot have
// them, as a sentence; empty: they are made.
std::string make_multisample_target(const GladGLContext& gl, const Target& target,
                                    MultisampleTarget& made);

}  // namespace edgecase
