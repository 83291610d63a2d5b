// SPDX-License-Identifier: MIT
#include "reference/stencil_buffer.h"

#include <fmt/format.h>

#include "reference/depth_buffer.h"

namespace edgecase {

namespace {

std::string doubt_of_claims(const GladGLContext& gl, GLenum attachment) {
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, name, &value);
    return value;
  };
  if (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE) return "it has no stencil buffer";
  const GLint bits = ask(GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
  return bits == 8 ? "" : fmt::format("its stencil buffer has {} bits", bits);
}

// Every bit is set in one of two clears and not in the other. A depth buffer, if there is one, is
// cleared after the first and read after the second.
std::string doubt_of_contents(const GladGLContext& gl, DepthFormat depth) {
  const bool has_depth = depth != DepthFormat::none;
  gl.Disable(GL_SCISSOR_TEST);
  gl.StencilMask(0xff);
  gl.DepthMask(GL_TRUE);
  float last_depth = 1;
  if (has_depth) gl.ClearBufferfv(GL_DEPTH, 0, &last_depth);
  for (GLint stencil : {0xa5, 0x5a}) {
    gl.ClearBufferiv(GL_STENCIL, 0, &stencil);
    if (has_depth && read_depths(gl, depth, 1, 1).front() != static_cast<double>(last_depth))
      return "clearing its stencil buffer changes its depth buffer";
    last_depth = 0;
    if (has_depth) gl.ClearBufferfv(GL_DEPTH, 0, &last_depth);
    const int read = read_stencils(gl, 1, 1).front();
    if (read != stencil)
      return fmt::format("its stencil buffer, cleared to {}, holds {}", stencil, read);
  }
  return "";
}

}  // namespace

DepthStencilStorage storage_of(DepthFormat depth, StencilFormat stencil) {
  if (stencil == StencilFormat::none)
    return {storage_of(depth), depth == DepthFormat::none ? GLenum{0} : GL_DEPTH_ATTACHMENT};
  switch (depth) {
    case DepthFormat::none:
      return {GL_STENCIL_INDEX8, GL_STENCIL_ATTACHMENT};
    case DepthFormat::depth16:
      return {};
    case DepthFormat::depth24:
      return {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT};
    case DepthFormat::depth32f:
      return {GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT};
  }
  return {};
}

std::string limit_of_formats(DepthFormat depth, StencilFormat stencil) {
  if (depth != DepthFormat::depth16 || stencil == StencilFormat::none) return "";
  return "OpenGL has no buffer of depth16 and stencil8";
}

std::string text_of_formats(DepthFormat depth, StencilFormat stencil) {
  if (stencil == StencilFormat::none) return depth == DepthFormat::none ? "" : name_of(depth);
  return depth == DepthFormat::none ? name_of(stencil)
                                    : fmt::format("{} and {}", name_of(depth), name_of(stencil));
}

void clear_depth_and_stencil(const GladGLContext& gl, const Target& target) {
  const GLint stencil = target.clear_stencil;
  if (target.depth != DepthFormat::none) {
    gl.DepthMask(GL_TRUE);
    gl.ClearBufferfv(GL_DEPTH, 0, &target.clear_depth);
  }
  if (target.stencil != StencilFormat::none) {
    gl.StencilMask(0xff);
    gl.ClearBufferiv(GL_STENCIL, 0, &stencil);
  }
}

std::string doubt_of_stencil_buffer(const GladGLContext& gl, GLenum attachment, DepthFormat depth) {
  std::string doubt = doubt_of_claims(gl, attachment);
  return doubt.empty() ? doubt_of_contents(gl, depth) : doubt;
}

std::vector<std::uint8_t> read_stencils(const GladGLContext& gl, int width, int height) {
  std::vector<std::uint8_t> stencils(static_cast<std::size_t>(width) *
                                     static_cast<std::size_t>(height));
  gl.ReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils.data());
  return stencils;
}

}  // namespace edgecase
