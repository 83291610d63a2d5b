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

}  // namespace edgecase::wire
