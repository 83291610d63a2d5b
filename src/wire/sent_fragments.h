// SPDX-License-Identifier: MIT
//
// Fragments as bytes (wire/binary.h): the bulk of a rendering, in as few as it takes. For src/wire
// alone.
//
// Neighbouring pixels of which the same is told, as of a primitive of one colour, go as a run. A
// GL's values are float32 and are sent so; where one is not, all are sent as doubles.
#pragma once

#include "model/rendering.h"
#include "model/scene.h"
#include "wire/binary.h"

namespace edgecase::wire {

// All fragments, then their details: one that tells nothing is none.
void write_fragments(Writer& io, const Rendering& rendering);

// The inverse, into a rendering of known size and samples. The lines of recordings tell no sign of
// zero, and what is recorded is to be what was seen: -0 becomes 0. Throws a Refusal for fragments
// that lie outside of the target, are of no primitive of the scene, cover none of its samples or
// tell a detail that it does not ask for, and for more than kMostFragments.
void read_fragments(Reader& io, const Scene& scene, Rendering& rendering);

// -0 becomes 0.
template <class Numbers>
void drop_signs_of_zero(Numbers& numbers) {
  for (double& number : numbers) number += 0.0;
}

// Hits: those that count the fragments, as they do where no test discards
// any, are not sent but counted again. For src/wire alone.
void write_hits(Writer& io, const Rendering& rendering);

// Into a rendering that has its fragments; throws a Refusal where they lie outside of it. Are the
// hits a count of the fragments? Otherwise they are whatever came.
bool read_hits(Reader& io, Rendering& rendering);

}  // namespace edgecase::wire

namespace edgecase {

// What must hold of a rendering that came as bytes before anybody looks at it: the limits within
// which answer_line.h reads a line. For src/wire alone; throws a Refusal.

// Does a fragment's detail have any of what details tell?
bool tells_something(const FragmentDetail& detail);

// Does a detail tell what the request does not ask for, or what there is of textured draws alone?
void check_detail(const FragmentDetail& detail, Details asked, bool is_textured);

// Sizes of planes and ranges of numbers; of a supersampled scene, of each pass. Fragments are
// checked where they are read.
void check_rendering(const Rendering& rendering, const Scene& scene);

// Hit counts that agree with fragments, which lie within the rendering.
void check_hits(const Rendering& rendering, const Scene& scene);

}  // namespace edgecase
