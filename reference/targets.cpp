// SPDX-License-Identifier: MIT
#include "reference/targets.h"

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

}  // namespace

const TargetBuffers* Targets::find(int width, int height) {
  const std::pair size(width, height);
  if (const auto found = sizes_.find(size); found != sizes_.end()) return &found->second;
  if (sizes_.size() >= kMostSizes) sizes_.clear();
  TargetBuffers made;
  if (!make_target(gl_, GL_RGBA8, size, made.color_image, made.color) ||
      !make_target(gl_, GL_R32F, size, made.count_image, made.count))
    return nullptr;
  return &sizes_.emplace(size, std::move(made)).first->second;
}

}  // namespace edgecase
