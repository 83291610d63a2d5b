// SPDX-License-Identifier: MIT
//
// Depth buffers: whether a framebuffer has the requested one, and its contents.
//
// A driver's report of its formats is only a claim: one keeps floats where 24 bits were requested,
// and reports 24 bits. So a buffer is cleared to a value that its format cannot store, and read.
#pragma once

#include <glad/gl.h>

#include <string>
#include <vector>

#include "model/scene.h"

namespace edgecase {

// The sized format of a renderbuffer; 0 for none.
GLenum storage_of(DepthFormat format);

// The integer for depth 1 in an unsigned format.
double largest_depth(DepthFormat format);

// Why the bound framebuffer's depth buffer does not have this format, as a sentence; empty if it
// does. `attachment` is GL_DEPTH_ATTACHMENT, or GL_DEPTH for the window. Clears the buffer.
std::string doubt_of_depth_buffer(const GladGLContext& gl, GLenum attachment, DepthFormat format);

// The sentence for such a doubt about a framebuffer object that was requested with `formats`.
std::string another_framebuffer(const std::string& formats, const std::string& doubt);

// The bound framebuffer's depths, 0 to 1, row by row from the bottom; for an unsigned format the
// stored integer over 2^bits - 1.
std::vector<double> read_depths(const GladGLContext& gl, DepthFormat format, int width, int height);

}  // namespace edgecase
