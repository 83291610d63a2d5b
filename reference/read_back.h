// SPDX-License-Identifier: MIT
//
// Reads buffers and images, in the forms that both APIs have.
#pragma once

#include <cstddef>

#include "reference/gl_objects.h"

namespace edgecase {

// Reads bytes of the buffer bound to GL_SHADER_STORAGE_BUFFER. False if that fails.
bool read_storage(const GladGLContext& gl, std::size_t offset, std::size_t size, void* bytes);

// The type of a framebuffer's colours.
enum class Channels { bytes, floats };

// The red channel of the lowest `height` rows of the bound framebuffer: width * height floats;
// bytes become 0 to 1.
void read_red(const GladGLContext& gl, Channels channels, int width, int height, float* red);

}  // namespace edgecase
