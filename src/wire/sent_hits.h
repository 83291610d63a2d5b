// SPDX-License-Identifier: MIT
//
// Hits as bytes (wire/binary.h): those that count the fragments, as they do where no test discards
// any, are not sent but counted again. For src/wire alone.
#pragma once

#include "model/rendering.h"
#include "wire/binary.h"

namespace edgecase::wire {

void write_hits(Writer& io, const Rendering& rendering);

// Into a rendering that has its fragments; throws a Refusal where they lie outside of it. Are the
// hits a count of the fragments? Otherwise they are whatever came.
bool read_hits(Reader& io, Rendering& rendering);

}  // namespace edgecase::wire
