// SPDX-License-Identifier: MIT
//
// Capture: the list of a pass's fragment shader invocations, written by the shader itself.
//
// The buffer has a counter and records. A shader invocation takes a slot from the counter and
// writes only if there is room; helper invocations never write. If the counter shows that there was
// no room, the buffer grows and the pass is drawn again; beyond a limit there is no capture.
//
// A record has pixel, primitive, depth and colour. A detailed one also has gl_FragCoord and six
// derivatives of the colour: it is written for scenes that request details. A textured one adds
// texture coordinates and the level of detail; its derivatives are those of the attribute before
// the lookup. For a multisampled target, the upper 16 bits of the pixel's column are the covered
// samples, gl_SampleMaskIn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "reference/gl_objects.h"

namespace edgecase {

class Capture {
 public:
  enum class Form { plain, detailed, textured };

  // The context must be current and outlive the capture.
  Capture(const GladGLContext& gl, Form form);

  // The largest number of fragments in a pass, limited by the driver or by us.
  std::uint32_t limit() const { return limit_; }
  // The present capacity in fragments, which is the value of the capacity uniform.
  std::uint32_t capacity() const { return capacity_; }

  // Empties the list and binds the buffer for the next pass.
  void begin();
  // The number of fragments of the pass since `begin`, whether or not there was room for all.
  std::uint32_t count();
  // Makes room for `count` fragments, at most limit(). Earlier captures are lost.
  void grow(std::uint32_t count);
  // Reads the captured fragments, sorted, into a rendering with a known number of samples; there
  // must have been room for all `count`. In a detailed capture, every fragment has all details of
  // its record; of derivatives only if they are `asked` for.
  void read(std::uint32_t count, Details asked, Rendering& rendering);
  // Whether some reading since `begin` failed. Count and fragments are then invalid.
  bool lost() const { return lost_; }

 private:
  template <class Record>
  void read_records(std::uint32_t count, Details asked, Rendering& rendering);

  const GladGLContext& gl_;
  Form form_;
  GlBuffer buffer_;
  std::uint32_t limit_ = 0;
  std::uint32_t capacity_ = 0;
  bool lost_ = false;
};

// A record in words of 32 bits. The first two are the pixel's column and row.
constexpr std::size_t kPixelWords = 2;

struct WordRange {
  std::size_t first;
  std::size_t end;
};

// The number of words of a record.
std::size_t words_of(Capture::Form form);
// The words of a record that report what is `asked` for beside depth and colour, in its order.
std::vector<WordRange> detail_words(Capture::Form form, Details asked);

// Appends the fragment of a record to a rendering with a known number of samples; `asked` as in
// Capture::read. `words` are those of the record from its first one on, and any that are missing
// are zeros.
void append_record(Capture::Form form, std::span<const std::uint32_t> words, Details asked,
                   Rendering& rendering);

}  // namespace edgecase
