// SPDX-License-Identifier: MIT
//
// Depth buffers: whether a framebuffer has the one that a target asks for, and what it holds.
//
// What a driver says of its formats is a claim: one keeps floats where 24 bits were asked for, and
// says 24 bits. So a buffer is cleared to a value that its format cannot hold, and read.
#pragma once

#include <glad/gl.h>

#include <string>
#include <vector>

#include "model/scene.h"

namespace edgecase {

// The sized format of a renderbuffer; 0 for none.
GLenum storage_of(DepthFormat format);

// The integer that stands for depth 1 in an unsigned format.
double largest_depth(DepthFormat format);

// Why the bound framebuffer's depth buffer is not one of this format, as a sentence; empty: it is.
// `attachment` is GL_DEPTH_ATTACHMENT, or GL_DEPTH for the window. Clears the buffer.
std::string doubt_of_depth_buffer(const GladGLContext& gl, GLenum attachment, DepthFormat format);

// The sentence that tells such a doubt of a framebuffer object, which was asked to have `formats`.
std::string another_framebuffer(const std::string& formats, const std::string& doubt);

// The bound framebuffer's depths, 0 to 1, row by row from the bottom: of an unsigned format the
// integer that is stored, over 2^bits - 1.
std::vector<double> read_depths(const GladGLContext& gl, DepthFormat format, int width, int height);

}  // namespace edgecase
