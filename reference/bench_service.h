// SPDX-License-Identifier: MIT
//
// The worker's side of `edgecase bench`: times what a context draws.
#pragma once

#include "reference/scene_renderer.h"
#include "wire/message.h"

namespace edgecase {

// Does what the request says. It measures the worker alone: nothing of asking and answering.
BenchAnswer time_scenes(SceneRenderer& renderer, const BenchRequest& request);

}  // namespace edgecase
