// SPDX-License-Identifier: MIT
//
// Features that OpenGL ES lacks, in general or on a driver, and which scenes need them. Such a
// scene gets a sentence and no rendering: any substitute would be judged by rules that it does not
// follow.
//
// Features of both APIs have the same specification, with one exception that scenes can show:
// OpenGL ES does not clip points and lines at the viewport's sides (model/side_clipping.h). They
// are drawn and compared by its own rules, except where those lead beyond exact coordinates.
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
