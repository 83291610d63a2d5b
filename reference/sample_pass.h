// SPDX-License-Identifier: MIT
//
// Common parts of all passes over the samples of a multisampled target.
#pragma once

#include <cstddef>

#include "reference/gl_objects.h"
#include "reference/multisample_target.h"

namespace edgecase {

inline std::size_t area_of(const MultisampleTarget& target) {
  return static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height);
}

// Prepares for one triangle that covers width x height pixels and writes all of them.
// `vertex_array`: without attributes.
inline void begin_sample_pass(const GladGLContext& gl, const GlVertexArray& vertex_array, int width,
                              int height) {
  constexpr GLenum kSwitchedOff[] = {GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_DITHER};
  for (GLenum off : kSwitchedOff) gl.Disable(off);
  gl.BindVertexArray(vertex_array.name());
  gl.Viewport(0, 0, width, height);
}

}  // namespace edgecase
