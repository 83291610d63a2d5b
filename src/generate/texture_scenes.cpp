// SPDX-License-Identifier: MIT
#include "generate/texture_scenes.h"

#include <array>
#include <utility>

#include "exact/elementary.h"
#include "generate/random_scenes.h"
#include "generate/random_shapes.h"
#include "generate/texture_parts.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kStreams = 0x50c;  // plus 4 times a TextureQuestion

constexpr int kCell = 8;  // pixels
constexpr int kAcross = kTextureTarget / kCell;
constexpr std::size_t kPoints = 64;
constexpr ImageSize kLarge{64, 64};

std::uint64_t stream_of(const TextureProbes& of) {
  return kStreams + window_streams(of.surface) + 4 * static_cast<std::uint64_t>(of.question);
}

Lookup lod_of(double level) {
  return {LookupKind::lod, static_cast<float>(level), {}, {}};
}

// A multiple of 2^-bits, from `low` to below `high`.
double grid_number(RandomSource& random, int low, int high, int bits) {
  return low +
         static_cast<double>(random.below(std::int64_t{high - low} << bits)) * power_of_2(-bits);
}

// Cell number n of a target. `steps` are powers of two, or short sums of them, so that its corners'
// coordinates are exact.
void add_numbered_cell(Draw& draw, int n, const TexelSteps& steps) {
  add_cell(draw, {n % kAcross * kCell, n / kAcross * kCell, kCell}, {0, 0}, steps, kLarge);
}

// Point number n of a target, a pixel large.
Draw point_draw(std::size_t n, const Sampler& sampler, const Lookup& lookup,
                std::array<double, 2> coordinates) {
  Draw draw = textured_draw(Primitive::points, sampler, lookup);
  const int at = static_cast<int>(n);
  draw.vertices.push_back(
      textured_vertex(at % kTextureTarget + 0.5, at / kTextureTarget + 0.5, coordinates));
  return draw;
}

Scene explicit_tie_scene(RandomSource& random, const TextureProbes& of) {
  Scene scene = textured_scene(of.surface, numbered_levels(kLarge));
  const Sampler sampler = sampler_of(Filter::nearest, Filter::nearest, MipFilter::nearest);
  for (std::size_t n = 0; n < kPoints / 2; ++n) {
    // Whole levels are ties for a renderer that adds half a level.
    const double level = static_cast<double>(random.below(6)) + (n % 4 == 3 ? 0 : 0.5);
    scene.draws.push_back(point_draw(n, sampler, lod_of(level), {0.5, 0.5}));
  }
  return scene;
}

// Lengths of 2^k times the root of 2; or 3/2 times, a tie if a line replaces the logarithm; or 2^k,
// a tie for a renderer that adds half a level.
Scene implicit_tie_scene(RandomSource& random, const TextureProbes& of) {
  Scene scene = textured_scene(of.surface, numbered_levels(kLarge));
  Draw draw = textured_draw(Primitive::triangles,
                            sampler_of(Filter::nearest, Filter::nearest, MipFilter::nearest), {});
  for (int n = 0; n < kAcross * kAcross; ++n) {
    const double size = power_of_2(static_cast<double>(random.below(6)));
    const double shorter = size / 4;
    TexelSteps steps{{random_sign(random) * size, random_sign(random) * size}, {-shorter, shorter}};
    if (n % 4 == 3) steps = {{random_sign(random) * 1.5 * size, 0}, {0, shorter}};
    if (n % 4 == 2) steps = {{random_sign(random) * size, 0}, {0, shorter}};
    if (random.one_in(2)) std::swap(steps.dx, steps.dy);
    add_numbered_cell(draw, n, steps);
  }
  scene.draws.push_back(std::move(draw));
  return scene;
}

// Square footprints of 2^k texels, in rows with a bias of half a level each, from the sampler or
// the shader.
Scene bias_tie_scene(RandomSource& random, const TextureProbes& of) {
  Scene scene = textured_scene(of.surface, numbered_levels(kLarge));
  for (int row = 0; row < kAcross; ++row) {
    Sampler sampler = sampler_of(Filter::nearest, Filter::nearest, MipFilter::nearest);
    Lookup lookup;
    const float bias = static_cast<float>(random.between(-1, 1)) + 0.5f;
    if (random.one_in(2))
      sampler.lod_bias = bias;
    else
      lookup = {LookupKind::bias, bias, {}, {}};
    Draw draw = textured_draw(Primitive::triangles, sampler, lookup);
    for (int column = 0; column < kAcross; ++column) {
      const double size = power_of_2(static_cast<double>(random.between(0, 5)));
      add_numbered_cell(draw, row * kAcross + column, {{size, 0}, {0, size}});
    }
    scene.draws.push_back(std::move(draw));
  }
  return scene;
}

// The two filters differ a quarter of a texel off a centre. No level is halfway between two.
Scene crossover_scene(RandomSource& random, const TextureProbes& of) {
  // Columns of black and white; further levels are grey.
  Scene scene = textured_scene(of.surface, texture_of({8, 8}, [](int level, int i, int) {
                                 return level > 0 ? 0.5f : i % 2 == 0 ? 0.0f : 1.0f;
                               }));
  for (std::size_t n = 0; n < kPoints; ++n) {
    const Sampler sampler = sampler_of(Filter::linear, Filter::nearest,
                                       n % 2 == 0 ? MipFilter::nearest : MipFilter::linear);
    const double level = n % 8 == 1 ? 0.5 : grid_number(random, -1, 1, 6) / 2;
    const double texel = static_cast<double>(random.below(8));
    scene.draws.push_back(point_draw(n, sampler, lod_of(level), {(texel + 0.25) / 8, 0.5625}));
  }
  return scene;
}

}  // namespace

Scene texture_probe(const TextureProbes& of, std::uint64_t index) {
  RandomSource random(of.seed, stream_of(of), index);
  switch (of.question) {
    case TextureQuestion::implicit_tie:
      break;
    case TextureQuestion::bias_tie:
      return bias_tie_scene(random, of);
    case TextureQuestion::explicit_tie:
      return explicit_tie_scene(random, of);
    case TextureQuestion::crossover:
      return crossover_scene(random, of);
  }
  return implicit_tie_scene(random, of);
}

}  // namespace edgecase
