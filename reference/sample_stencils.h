// SPDX-License-Identifier: MIT
//
// SampleStencils: the stencils of a multisampled target, each sample's by itself.
//
// A shader fetches them as integers (GL_DEPTH_STENCIL_TEXTURE_MODE, GL 4.6 core, 8.23) and writes
// them as floats into the image that depths go to as well. That every sample comes back with the
// bits that were written to it is proven for each format when it is first asked for.
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
  // Compiles what it draws with. The context must be current and outlive the object.
  static std::variant<SampleStencils, ProgramError> make(const GladGLContext& gl);

  // A plane for each sample, row by row from the bottom; empty where a sample holds what no 8 bits
  // do. Fragment state must be as a context begins with it. Leaves blending, depth test and scissor
  // test off, and another viewport, vertex array, program and framebuffer than before.
  std::vector<std::uint8_t> read(const MultisampleTarget& target) const;

  // Why stencils of a target's formats cannot be told, where buffers have so many samples, as a
  // sentence; empty: they can. Draws when it is first asked about them. Needs what `read` needs.
  std::string doubt_of(const Target& target);

 private:
  SampleStencils(const GladGLContext& gl, GlProgram fetch, GlProgram nothing);

  void fetch(const MultisampleTarget& target, int first) const;
  // Writes to each sample a value of its own, `flipped` with all bits the other way.
  void write_samples(const MultisampleTarget& target, std::uint8_t flipped) const;
  std::string prove(const Target& asked) const;

  const GladGLContext* gl_;
  GlProgram fetch_;
  GlProgram nothing_;
  GlVertexArray vertex_array_;  // without attributes
  std::map<std::tuple<DepthFormat, StencilFormat, int>, std::string> doubts_;
};

}  // namespace edgecase
