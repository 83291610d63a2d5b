// SPDX-License-Identifier: MIT
//
// What OpenGL ES does not have, as a whole or on a driver, and what of a scene asks for it. Such a
// scene gets a sentence and no rendering: whatever else was drawn in its stead would be judged by
// rules that it does not follow.
//
// Where both APIs have a thing, their specifications say the same of it, with one exception.
// OpenGL clips points and lines at all six planes of the clip volume; OpenGL ES clips them at the
// near and the far plane alone, and does not say what is drawn of them beyond the viewport.
// Triangles are clipped at all planes by both. So what of points and lines is not wholly in the
// viewport is not drawn here, except where the target ends there as well and all centres are
// inside.
#pragma once

#include <glad/gl.h>

#include <string>

#include "model/scene.h"

namespace edgecase {

// Which of its optional parts a context of OpenGL ES has, by its version and its extensions.
struct EsFeatures {
  bool noperspective = false;   // interpolation without perspective
  bool samples = false;         // gl_SampleMaskIn, and the qualifier sample
  bool sample_shading = false;  // glMinSampleShading
  bool borders = false;         // wrapping by clamp_to_border
  bool filters_floats = false;  // linear filters of textures of 32-bit floats
  bool float_targets = false;   // framebuffers of 32-bit floats, and blending in them
  bool reads_depths = false;    // glReadPixels of a depth buffer
  bool reads_stencils = false;  // the same of a stencil buffer
};

EsFeatures es_features(const GladGLContext& gl);

// What of a scene OpenGL ES with these features cannot draw, as a sentence; empty: it can draw all,
// as far as this tells.
std::string beyond_es(const Scene& scene, const EsFeatures& features);

}  // namespace edgecase
