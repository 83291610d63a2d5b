// SPDX-License-Identifier: MIT
//
// SampleReader: reads the samples of a multisampled target individually.
//
// glReadPixels cannot read multisampled framebuffers, and a resolved one no longer has samples. So
// a shader fetches every sample (texelFetch) into a single-sampled image in which planes of samples
// are stacked, and that is read. Colours of 8 bits and floats are unchanged.
//
// Unsigned depths need care: a fetch turns the integer n into a float32 number, and drivers that
// multiply by float32(1 / (2^24 - 1)) err by up to one step from n / (2^24 - 1). The number is
// converted back by the driver's own formula, if it is one of those below. The two largest integers
// of 24 bits may give the same number, 1, and then the depth test separates them. The formula, and
// that nothing is lost, are proven for each format on first use: a ramp of depths is drawn into a
// buffer with samples and into one without, whose integers glReadPixels returns.
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

// The result of fetching the integer n, where `largest` is the integer for depth 1.
enum class DepthConversion {
  quotient,  // float32(n / largest)
  product,   // float32(n) * float32(1 / largest)
};

class SampleReader {
 public:
  // Compiles its programs. The context must be current and outlive the reader.
  static std::variant<SampleReader, ProgramError> make(const GladGLContext& gl);

  // All of the following leave blending, depth test and scissor test off, and change viewport,
  // vertex array, program and framebuffer. Planes are ordered by sample, each row by row from the
  // bottom.

  // RGBA8, resolved by glBlitFramebuffer.
  std::vector<std::uint8_t> resolved(const MultisampleTarget& target) const;
  // RGBA8 of the colour image.
  std::vector<std::uint8_t> colors(const MultisampleTarget& target) const;
  // The samples of the count image.
  std::vector<float> counts(const MultisampleTarget& target) const;
  // The depth buffer's samples, 0 to 1; for an unsigned format the stored integer over 2^bits - 1.
  // The format must have no doubt. Nothing if some sample has a value that its format cannot have.
  // The count image is lost.
  std::optional<std::vector<double>> depths(const MultisampleTarget& target) const;

  // Why depths of a target's formats cannot be read with this number of samples, as a sentence;
  // empty if they can, or there are none. Draws on the first query.
  std::string doubt_of_depths(const Target& target);

 private:
  // The parameters of a conversion: a depth buffer's format, what it is packed with, and samples.
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
  std::map<Formats, DepthConversion> conversions_;  // only of unsigned formats
  std::map<Formats, std::string> doubts_;
};

}  // namespace edgecase
