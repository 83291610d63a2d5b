// SPDX-License-Identifier: MIT
//
// Checks whether the passes over a scene contradict each other, or the GL.
#pragma once

#include <cstdint>
#include <string>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// Why a rendering is unreliable, as a sentence; empty if nothing is found. Every fragment must come
// from a primitive, no pixel of one sample may have more fragments than the `most_hits` that its
// surface can count, and with fragment operations none more hits than fragments. (Without them both
// must be equal, which the reader of the answer checks.) Samples: see
// reference/multisample_doubt.h; their depths and stencils must exist if their colours do.
std::string doubt_of(const Scene& scene, const Rendering& rendering, std::uint32_t most_hits);

// Does a pixel of a target of one sample have more fragments than `most`?
bool has_pixel_of_more(const Rendering& rendering, std::uint32_t most);

}  // namespace edgecase
