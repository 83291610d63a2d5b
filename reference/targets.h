// SPDX-License-Identifier: MIT
//
// Framebuffer objects of the sizes that scenes ask for, kept for the next scene of the same size.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "model/scene.h"
#include "reference/gl_objects.h"

namespace edgecase {

struct TargetBuffers {
  GlRenderbuffer color_image;
  GlFramebuffer color;  // RGBA8, what the scene draws to
  GlRenderbuffer count_image;
  GlFramebuffer count;  // R32F, one addition per fragment: exact up to 2^24 fragments
};

class Targets {
 public:
  // The context must be current and outlive the targets.
  explicit Targets(const GladGLContext& gl) : gl_(gl) {}

  // The buffers of this size, contents undefined; null when the driver cannot have them. The
  // pointer is good until the next call.
  const TargetBuffers* find(int width, int height);

 private:
  const GladGLContext& gl_;
  std::map<std::pair<int, int>, TargetBuffers> sizes_;
};

}  // namespace edgecase
