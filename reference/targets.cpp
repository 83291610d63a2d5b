// SPDX-License-Identifier: MIT
#include "reference/targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reference/depth_buffer.h"
#include "reference/gl_api.h"
#include "reference/stencil_buffer.h"

namespace edgecase {

namespace {

// Sizes kept at a time; a suite uses a handful.
constexpr std::size_t kMostSizes = 16;

HitCounter byte_counter(GLuint framebuffer) {
  constexpr std::uint32_t kMost = 255;
  return {framebuffer, 1.0f / kMost, kMost};
}

HitCounter float_counter(GLuint framebuffer) {
  return {framebuffer, 1, std::uint32_t{1} << 24};
}

GlRenderbuffer make_image(const GladGLContext& gl, GLenum format, const Target& target) {
  GlRenderbuffer image = make_renderbuffer(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, image.name());
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, target.width, target.height);
  return image;
}

// A framebuffer of an image and, unless its name is 0, a depth or stencil buffer. Leaves it bound.
bool make_target(const GladGLContext& gl, const GlRenderbuffer& image, const GlRenderbuffer& depth,
                 GLenum attachment, GlFramebuffer& framebuffer) {
  framebuffer = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, image.name());
  if (depth.name() != 0)
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, depth.name());
  return gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

// Whether the bound framebuffer's buffer has 8 bits in each channel.
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

std::string Targets::make(const Target& target, Buffers& made) {
  const bool has_depth = target.depth != DepthFormat::none;
  const bool has_stencil = target.stencil != StencilFormat::none;
  const DepthStencilStorage storage = storage_of(target.depth, target.stencil);
  if (has_depth || has_stencil) made.depth_image = make_image(gl_, storage.format, target);
  made.color_image = make_image(gl_, GL_RGBA8, target);
  made.count_image = make_image(gl_, GL_R32F, target);
  if (!make_target(gl_, made.count_image, made.depth_image, storage.attachment, made.count) ||
      !make_target(gl_, made.color_image, made.depth_image, storage.attachment, made.color))
    return fmt::format("this driver has no {}x{} framebuffer{}{}", target.width, target.height,
                       has_depth || has_stencil ? " with " : "",
                       text_of_formats(target.depth, target.stencil));
  std::string doubt;
  if (has_depth) doubt = doubt_of_depth_buffer(gl_, GL_DEPTH_ATTACHMENT, target.depth);
  if (doubt.empty() && has_stencil)
    doubt = doubt_of_stencil_buffer(gl_, GL_STENCIL_ATTACHMENT, target.depth);
  return doubt.empty() ? ""
                       : another_framebuffer(text_of_formats(target.depth, target.stencil), doubt);
}

std::variant<Surfaces, std::string> Targets::find_objects(const Target& target) {
  const std::tuple key(target.width, target.height, target.depth, target.stencil);
  auto found = sizes_.find(key);
  if (found == sizes_.end()) {
    if (sizes_.size() >= kMostSizes) sizes_.clear();
    Buffers made;
    if (std::string reason = make(target, made); !reason.empty()) return reason;
    found = sizes_.emplace(key, std::move(made)).first;
  }
  const Buffers& buffers = found->second;
  return Surfaces{buffers.color.name(), byte_counter(buffers.color.name()),
                  float_counter(buffers.count.name()), nullptr};
}

std::variant<Surfaces, std::string> Targets::find_multisampled(const Target& target) {
  if (!samples_) {
    auto made = SampleReader::make(gl_);
    if (const auto* error = std::get_if<ProgramError>(&made)) return error->message;
    samples_.emplace(std::get<SampleReader>(std::move(made)));
  }
  if (std::string doubt = samples_->doubt_of_depths(target); !doubt.empty()) return doubt;
  if (target.stencil != StencilFormat::none) {
    if (!stencils_) {
      auto made = SampleStencils::make(gl_);
      if (const auto* error = std::get_if<ProgramError>(&made)) return error->message;
      stencils_.emplace(std::get<SampleStencils>(std::move(made)));
    }
    if (std::string doubt = stencils_->doubt_of(target); !doubt.empty()) return doubt;
  }
  auto found = std::find_if(multisampled_.begin(), multisampled_.end(),
                            [&](const MultisampleTarget& made) { return fits(made, target); });
  if (found == multisampled_.end()) {
    if (multisampled_.size() >= kMostSizes) multisampled_.clear();
    MultisampleTarget made;
    if (std::string reason = make_multisample_target(gl_, target, made); !reason.empty())
      return reason;
    found = multisampled_.insert(multisampled_.end(), std::move(made));
  }
  return Surfaces{found->color.name(), float_counter(found->count.name()), std::nullopt, &*found};
}

std::variant<Surfaces, std::string> Targets::find_window(const Target& target) {
  if (std::string error = context_.bind_window(target.width, target.height); !error.empty())
    return error;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return std::string("the window-system framebuffer is not complete");
  if (!is_rgba8(gl_, select_window_buffer(gl_)))
    return std::string("the window-system framebuffer is not RGBA8");
  if (target.depth != DepthFormat::none) {
    const std::string doubt = doubt_of_depth_buffer(gl_, GL_DEPTH, target.depth);
    if (!doubt.empty())
      return fmt::format("the window-system framebuffer is not {}: {}", name_of(target.depth),
                         doubt);
  }
  if (target.stencil != StencilFormat::none) {
    const std::string doubt = doubt_of_stencil_buffer(gl_, GL_STENCIL, target.depth);
    if (!doubt.empty())
      return fmt::format("the window-system framebuffer is not {}: {}", name_of(target.stencil),
                         doubt);
  }
  return Surfaces{0, byte_counter(0), std::nullopt, nullptr};
}

std::variant<Surfaces, std::string> Targets::find(const Target& target) {
  if (std::string limit = limit_of_formats(target.depth, target.stencil); !limit.empty())
    return limit;
  if (target.surface == Surface::window) return find_window(target);
  return target.samples > 1 ? find_multisampled(target) : find_objects(target);
}

}  // namespace edgecase
