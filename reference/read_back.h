// SPDX-License-Identifier: MIT
//
// Reading buffers and images back, in the forms that both APIs have.
#pragma once

#include <cstddef>

#include "reference/gl_objects.h"

namespace edgecase {

// Bytes of the buffer that is bound to GL_SHADER_STORAGE_BUFFER. False: they cannot be had.
bool read_storage(const GladGLContext& gl, std::size_t offset, std::size_t size, void* bytes);

// What a framebuffer's colours are.
enum class Channels { bytes, floats };

// The red channel of the lowest `height` rows of the bound framebuffer: width * height floats,
// those of bytes from 0 to 1.
void read_red(const GladGLContext& gl, Channels channels, int width, int height, float* red);

}  // namespace edgecase
