// SPDX-License-Identifier: MIT
//
// Textured scenes for tests: short forms to write one down.
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "model/scene.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {

// What is stored in texel (i, j) of a level.
using TexelOf = std::function<std::array<float, 4>(int i, int j, int level)>;

TextureLevel level_of(int width, int height, int level, const TexelOf& texel);
// A whole chain of two-dimensional images.
Texture chain_of(int width, int height, TextureFormat format, const TexelOf& texel);
// The largest image alone.
Texture single_of(int width, int height, TextureFormat format, const TexelOf& texel);
// Each texel unlike all others of up to 256 columns and 256 rows, and of other levels.
std::array<float, 4> distinct(int i, int j, int level);
// Any number that the format holds.
TexelOf random_texels(RandomNumbers& numbers, TextureFormat format);

// A rectangle from (x, y) to (x + width, y + height) pixels, and where it shows the texture.
struct Placement {
  std::array<double, 2> at{0, 0};
  std::array<double, 2> size{1, 1};
  std::array<float, 2> uv{0, 0};  // at its lower left corner
  std::array<float, 2> to{1, 1};  // at its upper right corner
};

// A scene of one textured rectangle, a strip of two triangles, that tells its level of detail.
Scene textured_scene(int width, int height, const Texture& texture, const Placement& placement,
                     const Sampler& sampler);

Sampler sampler_of(Filter filter, MipFilter mipmap, Wrap wrap = Wrap::repeat);

}  // namespace edgecase
