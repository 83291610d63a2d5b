// SPDX-License-Identifier: MIT
//
// Owners of GL objects: each deletes its object in its destructor. The context must then still be
// current, and the function table must outlive the owner.
#pragma once

#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace edgecase {

// Deletes by `Kind::remove(gl, name)`. Name 0 is no object.
template <class Kind>
class GlObject {
 public:
  GlObject() = default;
  GlObject(const GladGLContext& gl, GLuint name) : gl_(&gl), name_(name) {}
  GlObject(GlObject&& other) noexcept
      : gl_(other.gl_), name_(std::exchange(other.name_, GLuint{0})) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) Kind::remove(*gl_, name_);
  }

  GLuint name() const { return name_; }

 private:
  const GladGLContext* gl_ = nullptr;
  GLuint name_ = 0;
};

struct BufferKind {
  static void remove(const GladGLContext& gl, GLuint name) { gl.DeleteBuffers(1, &name); }
};
struct VertexArrayKind {
  static void remove(const GladGLContext& gl, GLuint name) { gl.DeleteVertexArrays(1, &name); }
};
struct RenderbufferKind {
  static void remove(const GladGLContext& gl, GLuint name) { gl.DeleteRenderbuffers(1, &name); }
};
struct FramebufferKind {
  static void remove(const GladGLContext& gl, GLuint name) { gl.DeleteFramebuffers(1, &name); }
};
struct ShaderKind {
  static void remove(const GladGLContext& gl, GLuint name) { gl.DeleteShader(name); }
};
struct ProgramKind {
  static void remove(const GladGLContext& gl, GLuint name) { gl.DeleteProgram(name); }
};
struct TextureKind {
  static void remove(const GladGLContext& gl, GLuint name) { gl.DeleteTextures(1, &name); }
};
struct SamplerKind {
  static void remove(const GladGLContext& gl, GLuint name) { gl.DeleteSamplers(1, &name); }
};

using GlBuffer = GlObject<BufferKind>;
using GlVertexArray = GlObject<VertexArrayKind>;
using GlRenderbuffer = GlObject<RenderbufferKind>;
using GlFramebuffer = GlObject<FramebufferKind>;
using GlShader = GlObject<ShaderKind>;
using GlTexture = GlObject<TextureKind>;
using GlSampler = GlObject<SamplerKind>;

// A program and the locations of its uniforms, which shaders number from 0 on. GLSL without
// explicit locations chooses its own (reference/uniform_layouts.h).
class GlProgram : public GlObject<ProgramKind> {
 public:
  static constexpr std::size_t kUniforms = 8;  // numbers are below

  using GlObject::GlObject;

  // The location of a uniform; -1, which the GL ignores, if the program has none of this number.
  GLint location(GLint number) const {
    return chosen_ ? (*chosen_)[static_cast<std::size_t>(number)] : number;
  }
  // The locations that GLSL chose, by number.
  void set_locations(const std::array<GLint, kUniforms>& chosen) { chosen_ = chosen; }

 private:
  std::optional<std::array<GLint, kUniforms>> chosen_;  // nothing: locations are the numbers
};

inline GlBuffer make_buffer(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  return {gl, name};
}
inline GlVertexArray make_vertex_array(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenVertexArrays(1, &name);
  return {gl, name};
}
inline GlRenderbuffer make_renderbuffer(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  return {gl, name};
}
inline GlFramebuffer make_framebuffer(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  return {gl, name};
}
inline GlTexture make_texture(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  return {gl, name};
}
inline GlSampler make_sampler(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenSamplers(1, &name);
  return {gl, name};
}

}  // namespace edgecase
