// SPDX-License-Identifier: MIT
//
// Checks whether the passes over a multisampled scene contradict each other, or the GL.
#pragma once

#include <string>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// Why a rendering of a multisampled scene is unreliable, as a sentence; empty if nothing is found.
// Every fragment must cover an existing sample. Unless a sample mask, alpha to coverage or disabled
// multisampling comes between a fragment's coverage and what is written, each sample must have as
// many hits as fragments that cover it, or with fragment operations at most that many.
std::string doubt_of_samples(const Scene& scene, const Rendering& rendering);

}  // namespace edgecase
