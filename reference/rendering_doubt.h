// SPDX-License-Identifier: MIT
//
// Do the passes over a scene contradict each other, or the GL?
#pragma once

#include <cstdint>
#include <string>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// Why a rendering is not to be relied upon, as a sentence; empty: nothing speaks against it. Every
// fragment must come from a primitive, no pixel of one sample may have more fragments than
// `most_hits`, which its surface can count, and with fragment operations none more hits than
// fragments. (Without them both are the same; whoever reads the answer sees to that.) Samples: see
// reference/multisample_doubt.h; their depths and stencils must be there if their colours are.
std::string doubt_of(const Scene& scene, const Rendering& rendering, std::uint32_t most_hits);

}  // namespace edgecase
