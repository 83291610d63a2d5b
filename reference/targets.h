// SPDX-License-Identifier: MIT
//
// The framebuffers for the passes of a scene: framebuffer objects, kept for the next scene of the
// same size and formats, or the framebuffer of the window system.
//
// Hits are counted by additive blending, on the scene's own target, or another format's rules would
// be counted: each hit adds 1/255, one step of an 8-bit channel, which is exact up to 255 hits. A
// framebuffer object with more hits at a pixel counts again in R32F, exact up to 2^24.
//
// If a scene requests a depth buffer, it is part of the framebuffer object and of that of the
// count, so that all passes are drawn with the same state; likewise a stencil buffer, packed with
// it. A window has only the buffers with which it was made, and scenes that request others are
// refused.
//
// Multisampled targets are framebuffer objects of a different kind, reference/multisample_target.h.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <variant>

#include "model/scene.h"
#include "reference/gl_context.h"
#include "reference/gl_objects.h"
#include "reference/multisample_target.h"
#include "reference/sample_reader.h"
#include "reference/sample_stencils.h"

namespace edgecase {

// How hits are counted in a framebuffer.
struct HitCounter {
  GLuint framebuffer = 0;       // its red channel holds hits, in units of `step`
  float step = 1;               // the value of one hit
  std::uint32_t most_hits = 0;  // per pixel; counts beyond are wrong
};

// Framebuffers by name.
struct Surfaces {
  GLuint color = 0;  // RGBA8: the scene's own target; 0 is the window
  HitCounter count;
  std::optional<HitCounter> larger_count;  // where a pixel has too many hits for the other
  // The two framebuffers if they are multisampled, which samples() reads; otherwise null.
  const MultisampleTarget* multisampled = nullptr;
};

class Targets {
 public:
  // The context must be current and outlive the targets, and `gl` be its functions.
  Targets(const GladGLContext& gl, GlContext& context) : gl_(gl), context_(context) {}

  // The framebuffers for a target, with undefined contents, or why the driver does not support
  // them. Valid until the next call.
  std::variant<Surfaces, std::string> find(const Target& target);
  // Reads multisampled targets; `find` must have found one.
  const SampleReader& samples() const { return *samples_; }
  // The same for a target with stencils.
  const SampleStencils& stencils() const { return *stencils_; }

 private:
  struct Buffers {
    GlRenderbuffer depth_image;  // depths and stencils, of both framebuffers; absent without either
    GlRenderbuffer color_image;
    GlFramebuffer color;
    GlRenderbuffer count_image;
    GlFramebuffer count;  // of many hits
  };

  // Why there are no such framebuffers, as a sentence; empty if they are made.
  std::string make(const Target& target, Buffers& made);
  std::variant<Surfaces, std::string> find_objects(const Target& target);
  std::variant<Surfaces, std::string> find_multisampled(const Target& target);
  std::variant<Surfaces, std::string> find_window(const Target& target);

  const GladGLContext& gl_;
  GlContext& context_;
  std::map<std::tuple<int, int, DepthFormat, StencilFormat>, Buffers> sizes_;
  std::list<MultisampleTarget> multisampled_;
  std::optional<SampleReader> samples_;     // made for the first multisampled target
  std::optional<SampleStencils> stencils_;  // and for the first with stencils
};

}  // namespace edgecase
