// SPDX-License-Identifier: MIT
//
// SampleReader: what the samples of a multisampled target hold, each by itself.
//
// glReadPixels reads no multisampled framebuffer, and a resolved one tells no samples. So a shader
// fetches every sample (texelFetch) into a single-sampled image in which planes of samples lie one
// above the other, and that is read. Colours of 8 bits and floats come through unchanged.
//
// Unsigned depths need care: a fetch turns the integer n into a float32 number, and drivers that
// multiply by float32(1 / (2^24 - 1)) are up to one step beside n / (2^24 - 1). The number is
// turned back by the driver's own formula, of those known here. The two largest integers of 24 bits
// may come as the same number, 1, and then the depth test tells them apart. Which formula it is,
// and that nothing is lost, is proven for each format when it is first asked for: a ramp of depths
// is drawn into a buffer with samples and into one without, whose integers glReadPixels gives.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "reference/gl_objects.h"
#include "reference/multisample_target.h"
#include "reference/programs.h"

namespace edgecase {

// What a fetch makes of the integer n, where `largest` stands for depth 1.
enum class DepthConversion {
  quotient,  // float32(n / largest)
  product,   // float32(n) * float32(1 / largest)
};

class SampleReader {
 public:
  // Compiles what it draws with. The context must be current and outlive the reader.
  static std::variant<SampleReader, ProgramError> make(const GladGLContext& gl);

  // All that follows leaves blending, depth test and scissor test off, and another viewport, vertex
  // array, program and framebuffer than before. Planes come by sample, each row by row from the
  // bottom.

  // RGBA8, resolved by glBlitFramebuffer.
  std::vector<std::uint8_t> resolved(const MultisampleTarget& target) const;
  // RGBA8 of the colour image.
  std::vector<std::uint8_t> colors(const MultisampleTarget& target) const;
  // Of the count image.
  std::vector<float> counts(const MultisampleTarget& target) const;
  // Of the depth buffer, 0 to 1: of an unsigned format the integer that is stored, over 2^bits - 1.
  // The format must be without doubt. None where a sample holds what its format does not. The count
  // image is lost.
  std::optional<std::vector<double>> depths(const MultisampleTarget& target) const;

  // Why depths of a target's formats cannot be told, where buffers have so many samples, as a
  // sentence; empty: they can, or there are none. Draws when it is first asked about them.
  std::string doubt_of_depths(const Target& target);

 private:
  // What a conversion depends on: a depth buffer's format, what it is packed with, and samples.
  using Formats = std::tuple<DepthFormat, StencilFormat, int>;

  SampleReader(const GladGLContext& gl, GlProgram fetch, GlProgram depth);

  // Fetches the samples from `first` on, as many as there is room for, and leaves them bound.
  void fetch(const MultisampleTarget& target, const GlTexture& image, const GlFramebuffer& planes,
             int first) const;
  std::vector<float> fetched_floats(const MultisampleTarget& target, const GlTexture& image) const;
  void draw_depths(const GlFramebuffer& framebuffer, int width, int height, GLenum test,
                   float scale) const;
  std::vector<float> largest_depths(const MultisampleTarget& target) const;
  std::string prove(const Target& target);

  const GladGLContext* gl_;
  GlProgram fetch_;
  GlProgram depth_;
  GlVertexArray vertex_array_;                      // without attributes
  std::map<Formats, DepthConversion> conversions_;  // of unsigned formats alone
  std::map<Formats, std::string> doubts_;
};

}  // namespace edgecase
