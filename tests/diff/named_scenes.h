// SPDX-License-Identifier: MIT
//
// The scenes that mutants are made of: each shows one thing, nothing touches the target's border,
// and no two of them look alike. All are 16 by 16 pixels.
#pragma once

#include <string>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

struct NamedScene {
  std::string name;
  Scene scene;
};

const std::vector<NamedScene>& named_scenes();

// The scene of that name, which must exist.
const Scene& scene_named(const std::string& name);

// A rendering of exactly these fragments: sorted, with the hits and pixels that belong to them.
Rendering compose(const Scene& scene, std::vector<Fragment> fragments);

// The right fragment of a primitive at a pixel, whether the primitive covers it or not.
Fragment fragment_at(const Scene& scene, int primitive, int x, int y);

}  // namespace edgecase
