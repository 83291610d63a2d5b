// SPDX-License-Identifier: MIT
//
// Common parts of generated scenes with textures: a texture of floats, a target with it, draws that
// look it up.
#pragma once

#include <array>
#include <functional>

#include "generate/random_scenes.h"
#include "model/scene.h"

namespace edgecase {

constexpr int kTextureTarget = 32;  // pixels, of each side of the target

// Texels of the base level per pixel along x and along y.
struct TexelSteps {
  std::array<double, 2> dx{};  // du/dx and dv/dx
  std::array<double, 2> dy{};
};

struct ImageSize {
  int width = 1;
  int height = 1;
};

// A component of a level's texel.
using TexelNumber = std::function<float(int level, int i, int component)>;

// A whole chain of floats; of one dimension if the height is 1.
Texture texture_of(ImageSize size, const TexelNumber& number);

// A whole chain: red is the level's number.
Texture numbered_levels(ImageSize size);

// A target with one texture and without draws; requests details of lookups.
Scene textured_scene(Surface surface, Texture texture);

Draw textured_draw(Primitive primitive, const Sampler& sampler, const Lookup& lookup);

Sampler sampler_of(Filter magnify, Filter minify, MipFilter mipmap);

// One vertex on whole pixels, or halves.
Vertex textured_vertex(double x, double y, std::array<double, 2> coordinates);

// A square of two triangles with lower left pixel (x, y), whose texture coordinates start at
// `origin` and grow by `steps`.
struct Cell {
  int x = 0;
  int y = 0;
  int side = 4;  // pixels
};
void add_cell(Draw& draw, const Cell& cell, std::array<double, 2> origin, const TexelSteps& steps,
              ImageSize texture);

// 1 or -1.
double random_sign(RandomSource& random);

}  // namespace edgecase
