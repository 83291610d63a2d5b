// SPDX-License-Identifier: MIT
//
// Stencil buffers, alone or packed with a depth buffer: whether one is as requested, and its
// contents. As with depth buffers, a driver's report is only a claim and is tested.
#pragma once

#include <glad/gl.h>

#include <cstdint>
#include <string>
#include <vector>

#include "model/scene.h"

namespace edgecase {

// The sized format of an image with both, and its attachment; 0 and 0 for neither. There is one for
// every pair except depth16 and stencil8, see limit_of_formats.
struct DepthStencilStorage {
  GLenum format = 0;
  GLenum attachment = 0;
};
DepthStencilStorage storage_of(DepthFormat depth, StencilFormat stencil);

// Why OpenGL has no such pair of buffers, as a sentence; empty if it has.
std::string limit_of_formats(DepthFormat depth, StencilFormat stencil);

// "depth24 and stencil8", "stencil8"; empty if there is neither.
std::string text_of_formats(DepthFormat depth, StencilFormat stencil);

// Clears the bound framebuffer's depth and stencil buffers, if any, to the target's values.
void clear_depth_and_stencil(const GladGLContext& gl, const Target& target);

// Why the bound single-sampled framebuffer's stencil buffer does not have 8 bits, as a sentence;
// empty if it does. `attachment` is GL_STENCIL_ATTACHMENT, or GL_STENCIL for the window. Clears the
// buffer, and the depth buffer if there is one: neither may change the other.
std::string doubt_of_stencil_buffer(const GladGLContext& gl, GLenum attachment, DepthFormat depth);

// The bound framebuffer's stencils, row by row from the bottom.
std::vector<std::uint8_t> read_stencils(const GladGLContext& gl, int width, int height);

}  // namespace edgecase
