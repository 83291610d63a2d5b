// SPDX-License-Identifier: MIT
#include "reference/gl_api.h"

namespace edgecase {

bool load_functions(GladGLContext& gl, const GlContext& context) {
  const auto load = [](void* user, const char* name) {
    return static_cast<const GlContext*>(user)->get_proc(name);
  };
  auto* user = const_cast<GlContext*>(&context);
  if (context.api() == GlApi::opengl) {
    if (gladLoadGLContextUserPtr(&gl, load, user) == 0) return false;
    // Part of OpenGL 4.0, and an identical extension before.
    if (gl.MinSampleShading == nullptr) gl.MinSampleShading = gl.MinSampleShadingARB;
    return true;
  }
  if (gladLoadGLES2ContextUserPtr(&gl, load, user) == 0) return false;
  // Part of OpenGL ES 3.2, and an identical extension before.
  if (gl.MinSampleShading == nullptr) gl.MinSampleShading = gl.MinSampleShadingOES;
  return true;
}

bool has_storage_blocks(const GladGLContext& gl) {
  GLint blocks = 0;
  if (gl.VERSION_4_3 != 0 || gl.ES_VERSION_3_1 != 0)
    gl.GetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
  return blocks > 0;
}

void set_depth_range(const GladGLContext& gl, float near, float far) {
  if (is_es(gl))
    gl.DepthRangef(near, far);
  else
    gl.DepthRange(static_cast<double>(near), static_cast<double>(far));
}

GLenum select_window_buffer(const GladGLContext& gl) {
  // A context that was made without a window draws to none of its buffers.
  if (is_es(gl)) {
    // Single- and double-buffered windows use the same name.
    constexpr GLenum kBack = GL_BACK;
    gl.DrawBuffers(1, &kBack);
    gl.ReadBuffer(kBack);
    return kBack;
  }
  GLboolean doubled = GL_FALSE;
  gl.GetBooleanv(GL_DOUBLEBUFFER, &doubled);
  const GLenum buffer = doubled == GL_TRUE ? GL_BACK : GL_FRONT;
  gl.DrawBuffer(buffer);
  gl.ReadBuffer(buffer);
  return doubled == GL_TRUE ? GL_BACK_LEFT : GL_FRONT_LEFT;
}

}  // namespace edgecase
