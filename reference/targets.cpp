// SPDX-License-Identifier: MIT
#include "reference/targets.h"

#include <fmt/format.h>

namespace edgecase {

namespace {

// Sizes kept at a time; a suite uses a handful.
constexpr std::size_t kMostSizes = 16;

bool make_target(const GladGLContext& gl, GLenum format, std::pair<int, int> size,
                 GlRenderbuffer& image, GlFramebuffer& framebuffer) {
  image = make_renderbuffer(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, image.name());
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, size.first, size.second);
  framebuffer = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, image.name());
  return gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

// Has the bound framebuffer's buffer 8 bits in each channel?
bool is_rgba8(const GladGLContext& gl, GLenum buffer) {
  constexpr GLenum kChannels[] = {
      GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE,
      GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE};
  for (GLenum channel : kChannels) {
    GLint bits = 0;
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, buffer, channel, &bits);
    if (bits != 8) return false;
  }
  return true;
}

}  // namespace

std::variant<Surfaces, std::string> Targets::find_objects(int width, int height) {
  constexpr std::uint32_t kFloatHits = std::uint32_t{1} << 24;
  const std::pair size(width, height);
  auto found = sizes_.find(size);
  if (found == sizes_.end()) {
    if (sizes_.size() >= kMostSizes) sizes_.clear();
    Buffers made;
    if (!make_target(gl_, GL_RGBA8, size, made.color_image, made.color) ||
        !make_target(gl_, GL_R32F, size, made.count_image, made.count))
      return fmt::format("this driver has no {}x{} framebuffer", width, height);
    found = sizes_.emplace(size, std::move(made)).first;
  }
  return Surfaces{found->second.color.name(), found->second.count.name(), 1, kFloatHits};
}

std::variant<Surfaces, std::string> Targets::find_window(int width, int height) {
  constexpr std::uint32_t kByteHits = 255;
  if (std::string error = context_.bind_window(width, height); !error.empty()) return error;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return std::string("the window-system framebuffer is not complete");
  // A context that began without a window draws to no buffer of it.
  GLboolean doubled = GL_FALSE;
  gl_.GetBooleanv(GL_DOUBLEBUFFER, &doubled);
  const GLenum buffer = doubled == GL_TRUE ? GL_BACK : GL_FRONT;
  gl_.DrawBuffer(buffer);
  gl_.ReadBuffer(buffer);
  if (!is_rgba8(gl_, doubled == GL_TRUE ? GL_BACK_LEFT : GL_FRONT_LEFT))
    return std::string("the window-system framebuffer is not RGBA8");
  return Surfaces{0, 0, 1.0f / kByteHits, kByteHits};
}

std::variant<Surfaces, std::string> Targets::find(const Target& target) {
  return target.surface == Surface::window ? find_window(target.width, target.height)
                                           : find_objects(target.width, target.height);
}

}  // namespace edgecase
