// SPDX-License-Identifier: MIT
//
// The worker's side of `edgecase bench`: times drawing in a context.
#pragma once

#include "reference/scene_renderer.h"
#include "wire/message.h"

namespace edgecase {

// Executes the request. Only the worker is timed, not the exchange of messages.
BenchAnswer time_scenes(SceneRenderer& renderer, const BenchRequest& request);

}  // namespace edgecase
