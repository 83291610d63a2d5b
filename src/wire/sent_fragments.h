// SPDX-License-Identifier: MIT
//
// Fragments and hits as bytes (wire/binary.h): the bulk of a rendering, in as few as it takes. For
// src/wire alone.
//
// A GL's values are float32 and are sent so; where one is not, all are sent as doubles. Hits that
// count the fragments, as they do where no test discards any, are not sent but counted again.
#pragma once

#include "model/rendering.h"
#include "wire/binary.h"

namespace edgecase::wire {

// All fragments, then their details: one that tells nothing is none.
void write_fragments(Writer& io, const Rendering& rendering);

// The inverse, into a rendering of known size. The lines of recordings tell no sign of zero, and
// what is recorded is to be what was seen: -0 becomes 0.
void read_fragments(Reader& io, Rendering& rendering);

void write_hits(Writer& io, const Rendering& rendering);

// Into a rendering that has its fragments; throws Refusal where they lie outside of it.
void read_hits(Reader& io, Rendering& rendering);

// -0 becomes 0.
template <class Numbers>
void drop_signs_of_zero(Numbers& numbers) {
  for (double& number : numbers) number += 0.0;
}

}  // namespace edgecase::wire
