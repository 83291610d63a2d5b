// SPDX-License-Identifier: MIT
//
// What scenes of textures are put together from.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>

#include "generate/random_source.h"
#include "model/scene.h"

namespace edgecase {

// Texels per pixel of the base level along x and along y.
struct TexelSteps {
  std::array<double, 2> dx{};  // du/dx and dv/dx
  std::array<double, 2> dy{};
};

struct ImageSize {
  int width = 1;
  int height = 1;
};

// What a component of a level's texel is: code or number, as the format stores it.
using TexelNumber = std::function<float(int level, int i, int j, int component)>;

// A texture of so many levels, 0: a whole chain.
Texture texture_of(TextureFormat format, ImageSize size, int levels, const TexelNumber& number);

// A whole chain of floats: red is the level's number.
Texture numbered_levels(ImageSize size);

// The number that stands for 1 in a format.
constexpr float full(TextureFormat format) {
  return format == TextureFormat::rgba32f ? 1.0f : 255.0f;
}

// A target with one texture, without draws; what lookups are is told.
Scene textured_scene(Surface surface, ImageSize target, Texture texture);

Draw textured_draw(Primitive primitive, const Sampler& sampler, const Lookup& lookup);

// The sampler that the questions begin with: all filters nearest, the levels blended or not.
Sampler sampler_of(Filter magnify, Filter minify, MipFilter mipmap);

// One vertex on whole pixels, or halves.
Vertex textured_vertex(double x, double y, std::array<double, 2> coordinates);

// A square of two triangles, lower left pixel (x, y), whose texture coordinates begin at `origin`
// and grow by `steps`.
struct Cell {
  int x = 0;
  int y = 0;
  int side = 4;  // pixels
};
void add_cell(Draw& draw, const Cell& cell, std::array<double, 2> origin, const TexelSteps& steps,
              ImageSize texture);

// The draw of a scene; where its texture has one dimension, t is 0 everywhere.
void add_draw(Scene& scene, Draw draw);

// A point of one pixel, the n-th of a target of that width.
Draw point_draw(std::size_t n, int target_width, const Sampler& sampler, const Lookup& lookup,
                std::array<double, 2> coordinates);

// From 0 to 1, of 24 bits.
double unit(RandomSource& random);

}  // namespace edgecase
