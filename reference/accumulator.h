// SPDX-License-Identifier: MIT
//
// Accumulator: the weighted mean of a scene's passes, computed by the GL.
//
//   pass, drawn into RGBA32F -> times its weight, added by blending -> over the sum of all weights
//
// Colours are neither clamped nor rounded on the way: the images of a pass and of the sum hold
// float32 numbers (GL 4.6 core, 17.3.6: blending is as precise as the image). The mean is read
// unchanged, and drawn once more into RGBA8, so that the conversion is the GL's own. A driver that
// clamps, rounds or does not add such numbers is detected before the first scene.
//
// It does not draw passes and does not know their scenes.
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

  // Starts a sum of passes for targets of this size and depth format. Returns why the driver does
  // not support it, as a sentence; if empty, the other members may be called.
  std::string begin(const Target& target);

  // The framebuffer for drawing a pass; it is not cleared.
  GLuint pass() const { return pass_.framebuffer.name(); }
  // Adds the current pass, times a weight.
  void add(std::int64_t weight);
  // Fills `accumulated` and `pixels` from the sum.
  void read(Rendering& rendering);

  // `add` and `read` leave blending, dithering, depth test and scissor test off, and change
  // viewport, vertex array, program and framebuffer.

 private:
  struct Image {
    GlTexture texture;
    GlFramebuffer framebuffer;
  };

  std::string compile();
  std::string make(const Target& target);
  bool make_image(Image& image);
  // Tests whether floats are preserved, by drawing two passes of known colours.
  std::string prove();
  void set_state();
  // Draws an image into a framebuffer with a program that has one number.
  void draw(const GlProgram& program, double number, const Image& from, GLuint to);

  const GladGLContext* gl_;
  std::optional<std::string> problem_;  // why no target is supported; nothing: not tested yet
  GlProgram product_;                   // multiplies the image by a number
  GlProgram quotient_;                  // divides the image by a number
  GlVertexArray vertex_array_;          // without attributes
  // Those of the latest target.
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
