// SPDX-License-Identifier: MIT
//
// Features that OpenGL ES lacks, in general or on a driver, and which scenes need them. Such a
// scene gets a sentence and no rendering: any substitute would be judged by rules that it does not
// follow.
//
// Features of both APIs have the same specification, with one exception. OpenGL clips points and
// lines at all six planes of the clip volume. OpenGL ES clips them at the near and the far plane
// only, and does not define what is drawn of them beyond the viewport. Both clip triangles at all
// planes. So points and lines that are not entirely in the viewport are not drawn here, unless the
// target ends there as well and all centres are inside.
#pragma once

#include <glad/gl.h>

#include <string>

#include "model/scene.h"

namespace edgecase {

// The optional features of an OpenGL ES context, by its version and its extensions.
struct EsFeatures {
  bool noperspective = false;    // interpolation without perspective
  bool sampled_textures = true;  // textures of multisampled targets, of which samples are read
  bool samples = false;          // gl_SampleMaskIn, and the qualifier sample
  bool sample_shading = false;   // glMinSampleShading
  bool borders = false;          // wrapping by clamp_to_border
  bool filters_floats = false;   // linear filters of textures of 32-bit floats
  bool float_targets = false;    // framebuffers of 32-bit floats, and blending in them
  bool reads_depths = false;     // glReadPixels of a depth buffer
  bool reads_stencils = false;   // the same of a stencil buffer
};

EsFeatures es_features(const GladGLContext& gl);

// What OpenGL ES with these features cannot draw of a scene, as a sentence; empty if it can draw
// everything, as far as these checks go.
std::string beyond_es(const Scene& scene, const EsFeatures& features);

}  // namespace edgecase
