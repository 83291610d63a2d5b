// SPDX-License-Identifier: MIT
//
// SampleStencils: reads the stencils of a multisampled target, sample by sample.
//
// A shader fetches them as integers (GL_DEPTH_STENCIL_TEXTURE_MODE, GL 4.6 core, 8.23) and writes
// them as floats into the image that depths also use. For each format, the first use proves that
// every sample returns the bits that were written to it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "reference/gl_objects.h"
#include "reference/multisample_target.h"
#include "reference/programs.h"

namespace edgecase {

class SampleStencils {
 public:
  // Compiles its programs. The context must be current and outlive the object.
  static std::variant<SampleStencils, ProgramError> make(const GladGLContext& gl);

  // One plane per sample, row by row from the bottom; empty if a sample has a value that does not
  // fit 8 bits. Fragment state must be a context's initial state. Leaves blending, depth test and
  // scissor test off, and changes viewport, vertex array, program and framebuffer.
  std::vector<std::uint8_t> read(const MultisampleTarget& target) const;

  // Why stencils of a target's formats cannot be read with this number of samples, as a sentence;
  // empty if they can. Draws on the first query, with the same requirements as `read`.
  std::string doubt_of(const Target& target);

 private:
  SampleStencils(const GladGLContext& gl, GlProgram fetch, GlProgram nothing);

  void fetch(const MultisampleTarget& target, int first) const;
  // Writes a distinct value to each sample, with the bits of `flipped` inverted.
  void write_samples(const MultisampleTarget& target, std::uint8_t flipped) const;
  std::string prove(const Target& asked) const;

  const GladGLContext* gl_;
  GlProgram fetch_;
  GlProgram nothing_;
  GlVertexArray vertex_array_;  // without attributes
  std::map<std::tuple<DepthFormat, StencilFormat, int>, std::string> doubts_;
};

}  // namespace edgecase
