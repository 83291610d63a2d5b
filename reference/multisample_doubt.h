// SPDX-License-Identifier: MIT
//
// Do the passes over a multisampled scene contradict each other, or the GL?
#pragma once

#include <string>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// Why a rendering of a multisampled scene is not to be relied upon, as a sentence; empty: nothing
// speaks against it. Every fragment must cover a sample that there is. Where no sample mask, no
// alpha to coverage and no disabled multisampling stands between a fragment's coverage and what is
// written, each sample must have as many hits as fragments that cover it, or with fragment
// operations at most so many.
std::string doubt_of_samples(const Scene& scene, const Rendering& rendering);

}  // namespace edgecase
