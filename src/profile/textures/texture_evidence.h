// SPDX-License-Identifier: MIT
//
// What renderings tell of their textured fragments.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "exact/pixel.h"
#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// One lookup, as the renderer tells it.
struct ToldLookup {
  PixelPosition pixel;
  int primitive = 0;
  std::array<double, 4> color{};
  std::optional<std::array<double, 2>> coordinates;  // s and t
  std::optional<double> lambda_prime;                // textureQueryLod's y
};

struct ToldScene {
  Scene scene;
  std::vector<ToldLookup> lookups;
};

// Some of a scene's fragments with colours, evenly spread over their list: `most` at most.
std::vector<ToldLookup> told_lookups(const Rendering& rendering, std::size_t most);
ToldScene told_scene(Scene scene, const Rendering& rendering, std::size_t most);

}  // namespace edgecase
