// SPDX-License-Identifier: MIT
//
// Accumulator: the weighted mean of a scene's passes, made by the GL.
//
//   pass, drawn into RGBA32F -> times its weight, added by blending -> over the sum of all weights
//
// Colours are neither clamped nor rounded on the way: the image that a pass is drawn to, and the
// one that sums up, hold float32 numbers (GL 4.6 core, 17.3.6: blending is as precise as the
// image). The mean is read as it is, and drawn once more into RGBA8, so that the conversion is the
// GL's own. A driver that clamps, rounds or does not add such numbers is found out before the first
// scene.
//
// It draws no pass itself, and does not know what a pass is a pass of.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "model/rendering.h"
#include "model/scene.h"
#include "reference/gl_objects.h"
#include "reference/programs.h"

namespace edgecase {

class Accumulator {
 public:
  // The context must be current and outlive the accumulator. Nothing is compiled or made yet.
  explicit Accumulator(const GladGLContext& gl) : gl_(&gl) {}

  // Forgets what was added, for passes of a target of this size and depth format. Why this driver
  // has none such, as a sentence; empty: the other members may be called.
  std::string begin(const Target& target);

  // The framebuffer to which a pass is drawn; it is not cleared.
  GLuint pass() const { return pass_.framebuffer.name(); }
  // Adds what the pass shows, times a weight.
  void add(std::int64_t weight);
  // Fills `accumulated` and `pixels` from all that was added.
  void read(Rendering& rendering);

  // `add` and `read` leave blending, dithering, depth test and scissor test off, and another
  // viewport, vertex array, program and framebuffer than before.

 private:
  struct Image {
    GlTexture texture;
    GlFramebuffer framebuffer;
  };

  std::string compile();
  std::string make(const Target& target);
  bool make_image(Image& image);
  // Do floats come through as they are? Draws two passes of known colours.
  std::string prove();
  void set_state();
  // Draws an image into a framebuffer by a program that has one number.
  void draw(const GlProgram& program, double number, const Image& from, GLuint to);

  const GladGLContext* gl_;
  std::optional<std::string> problem_;  // why it works for no target; none: not tried yet
  GlProgram product_;                   // the image times a number
  GlProgram quotient_;                  // the image over a number
  GlVertexArray vertex_array_;          // without attributes
  // The last target's.
  int width_ = 0;
  int height_ = 0;
  DepthFormat depth_ = DepthFormat::none;
  GlRenderbuffer depth_image_;
  Image pass_;
  Image sum_;
  GlRenderbuffer bytes_image_;
  GlFramebuffer bytes_;
  std::int64_t total_ = 0;  // of weights
};

}  // namespace edgecase
