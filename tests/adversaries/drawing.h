// SPDX-License-Identifier: MIT
//
// A scene as an adversary draws it.
#pragma once

#include "model/rendering.h"
#include "model/scene.h"
#include "tests/adversaries/freedoms.h"

namespace edgecase::adversary {

Rendering draw(const Scene& scene, const Freedoms& freedoms);

}  // namespace edgecase::adversary
