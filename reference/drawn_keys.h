// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/scene.h"

namespace edgecase {

// The key of a scene (model/scene_fields.h) that is not at its default and that nothing here draws;
// empty if there is none. A new key is refused by its name until it is listed.
std::string key_not_drawn(const Scene& scene);

}  // namespace edgecase
