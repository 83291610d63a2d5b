// SPDX-License-Identifier: MIT
#include "reference/read_back.h"

#include <cstdint>
#include <cstring>
#include <vector>

#include "reference/gl_api.h"

namespace edgecase {

bool read_storage(const GladGLContext& gl, std::size_t offset, std::size_t size, void* bytes) {
  if (!is_es(gl)) {
    gl.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset),
                        static_cast<GLsizeiptr>(size), bytes);
    return true;
  }
  const void* mapped = gl.MapBufferRange(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(offset),
                                         static_cast<GLsizeiptr>(size), GL_MAP_READ_BIT);
  if (mapped == nullptr) return false;
  std::memcpy(bytes, mapped, size);
  // The mapped contents may have been lost meanwhile.
  return gl.UnmapBuffer(GL_SHADER_STORAGE_BUFFER) == GL_TRUE;
}

void read_red(const GladGLContext& gl, Channels channels, int width, int height, float* red) {
  if (!is_es(gl)) return gl.ReadPixels(0, 0, width, height, GL_RED, GL_FLOAT, red);
  // OpenGL ES reads four channels, of the framebuffer's own type.
  const auto area = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (channels == Channels::bytes) {
    std::vector<std::uint8_t> bytes(4 * area);
    gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    for (std::size_t i = 0; i < area; ++i) red[i] = static_cast<float>(bytes[4 * i]) / 255.0f;
    return;
  }
  std::vector<float> floats(4 * area);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, floats.data());
  for (std::size_t i = 0; i < area; ++i) red[i] = floats[4 * i];
}

}  // namespace edgecase
