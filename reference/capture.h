// SPDX-License-Identifier: MIT
//
// Capture: the list of fragment shader invocations of a pass, written by the shader itself.
//
// The buffer holds a counter and records. A shader invocation takes a slot from the counter and
// writes only where there is room; helper invocations never write. When the counter says that there
// was no room, the buffer grows and the pass is drawn again; beyond a limit there is no capture.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/rendering.h"
#include "reference/gl_objects.h"

namespace edgecase {

class Capture {
 public:
  // The context must be current and outlive the capture.
  explicit Capture(const GladGLContext& gl);

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
  // The captured fragments, sorted; all `count` of them must have had room.
  std::vector<Fragment> read(std::uint32_t count);

 private:
  const GladGLContext& gl_;
  GlBuffer buffer_;
  std::uint32_t limit_ = 0;
  std::uint32_t capacity_ = 0;
};

}  // namespace edgecase
