// SPDX-License-Identifier: MIT
//
// Capture: the list of fragment shader invocations of a pass, written by the shader itself.
//
// The buffer holds a counter and records. A shader invocation takes a slot from the counter and
// writes only where there is room; helper invocations never write. When the counter says that there
// was no room, the buffer grows and the pass is drawn again; beyond a limit there is no capture.
//
// A record holds pixel, primitive, depth and colour, in 32 bytes. A detailed one holds gl_FragCoord
// and six derivatives of the colour as well, in 144: it is written for scenes that ask for details.
// A textured one, of 160 bytes, adds texture coordinates and the level of detail; its derivatives
// are those of the attribute before anything is looked up. Of a multisampled target, the pixel's
// column has the samples that the fragment covers, gl_SampleMaskIn, in its upper 16 bits.
#pragma once

#include <cstddef>
#include <cstdint>

#include "model/rendering.h"
#include "reference/gl_objects.h"

namespace edgecase {

class Capture {
 public:
  enum class Form { plain, detailed, textured };

  // The context must be current and outlive the capture.
  Capture(const GladGLContext& gl, Form form);

  // Most fragments that one pass may have: a limit of the driver, or ours.
  std::uint32_t limit() const { return limit_; }
  // Fragments that the buffer has room for now: the value of the capacity uniform.
  std::uint32_t capacity() const { return capacity_; }

  // Empties the list and binds the buffer for the pass that is drawn next.
  void begin();
  // Fragments that the pass since `begin` had, whether or not there was room for all.
  std::uint32_t count();
  // Makes room for `count` fragments, of at most limit(). What was captured is lost.
  void grow(std::uint32_t count);
  // The captured fragments, sorted, of a rendering that knows its number of samples; all `count` of
  // them must have had room. Of a detailed capture, every fragment has all details of its record.
  void read(std::uint32_t count, Rendering& rendering);
  // Was something since `begin` not to be read? Then neither the count nor the fragments are what
  // was captured.
  bool lost() const { return lost_; }

 private:
  std::size_t record_size() const;
  template <class Record>
  void read_records(std::uint32_t count, Rendering& rendering);

  const GladGLContext& gl_;
  Form form_;
  GlBuffer buffer_;
  std::uint32_t limit_ = 0;
  std::uint32_t capacity_ = 0;
  bool lost_ = false;
};

}  // namespace edgecase
