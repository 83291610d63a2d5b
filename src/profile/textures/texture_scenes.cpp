// SPDX-License-Identifier: MIT
#include "profile/textures/textures.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "exact/elementary.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kProbeStreams = 0x500;
constexpr std::uint64_t kChainStreams = 0x600;
constexpr std::uint64_t kWindowStreams = 0x1000;

constexpr int kTarget = 32;  // pixels
constexpr int kCell = 8;
constexpr int kAcross = kTarget / kCell;
constexpr std::size_t kPoints = 64;
constexpr ImageSize kLarge{64, 64};

std::uint64_t window_streams(Surface surface) {
  return surface == Surface::window ? kWindowStreams : 0;
}

std::uint64_t stream_of(const TextureProbes& of) {
  return kProbeStreams + window_streams(of.surface) + 4 * static_cast<std::uint64_t>(of.question) +
         static_cast<std::uint64_t>(of.format);
}

Lookup lod_of(double level) {
  return {LookupKind::lod, static_cast<float>(level), {}, {}};
}

// A multiple of 2^-bits, from `low` to below `high`.
double grid_number(RandomSource& random, int low, int high, int bits) {
  return low +
         static_cast<double>(random.below(std::int64_t{high - low} << bits)) * power_of_2(-bits);
}

Draw cells_draw(const Sampler& sampler, const Lookup& lookup) {
  return textured_draw(Primitive::triangles, sampler, lookup);
}

// Cell number n of a target. `steps` are powers of two, or short sums of them, so that its corners'
// coordinates are exact.
void add_numbered_cell(Draw& draw, int n, const TexelSteps& steps) {
  add_cell(draw, {n % kAcross * kCell, n / kAcross * kCell, kCell}, {0, 0}, steps, kLarge);
}

double random_sign(RandomSource& random) {
  return static_cast<double>(random.sign());
}

// ------------------------------------------------------------------------------------------ levels

// Levels black, full, black: the lookup shows the weight, or 1 minus the weight.
Scene level_weight_scene(RandomSource& random, const TextureProbes& of) {
  const float most = full(of.format);
  Scene scene = textured_scene(of.surface, {kTarget, kTarget},
                               texture_of(of.format, {4, 4}, 0, [&](int level, int, int, int) {
                                 return level == 1 ? most : 0.0f;
                               }));
  const Sampler sampler = sampler_of(Filter::nearest, Filter::nearest, MipFilter::linear);
  for (std::size_t n = 0; n < kPoints; ++n) {
    // Sometimes on the borders of coarse steps, and in the middle.
    const double level = n % 8 == 0   ? grid_number(random, 0, 2, 5)
                         : n % 8 == 1 ? grid_number(random, 0, 2, 9)
                         : n % 8 == 2 ? grid_number(random, 0, 2, 1)
                                      : grid_number(random, 0, 2, 14);
    scene.draws.push_back(point_draw(n, kTarget, sampler, lod_of(level), {0.375, 0.375}));
  }
  return scene;
}

Scene explicit_tie_scene(RandomSource& random, const TextureProbes& of) {
  Scene scene = textured_scene(of.surface, {kTarget, kTarget}, numbered_levels(kLarge));
  const Sampler sampler = sampler_of(Filter::nearest, Filter::nearest, MipFilter::nearest);
  for (std::size_t n = 0; n < kPoints / 2; ++n) {
    // Whole levels are ties for a renderer that adds half a level.
    const double level = static_cast<double>(random.below(6)) + (n % 4 == 3 ? 0 : 0.5);
    scene.draws.push_back(point_draw(n, kTarget, sampler, lod_of(level), {0.5, 0.5}));
  }
  return scene;
}

// Lengths of 2^k times the root of 2; or 3/2 times, a tie if a line replaces the logarithm; or 2^k,
// a tie for a renderer that adds half a level.
Scene implicit_tie_scene(RandomSource& random, const TextureProbes& of) {
  Scene scene = textured_scene(of.surface, {kTarget, kTarget}, numbered_levels(kLarge));
  Draw draw = cells_draw(sampler_of(Filter::nearest, Filter::nearest, MipFilter::nearest), {});
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
  Scene scene = textured_scene(of.surface, {kTarget, kTarget}, numbered_levels(kLarge));
  for (int row = 0; row < kAcross; ++row) {
    Sampler sampler = sampler_of(Filter::nearest, Filter::nearest, MipFilter::nearest);
    Lookup lookup;
    const float bias = static_cast<float>(random.between(-1, 1)) + 0.5f;
    if (random.one_in(2))
      sampler.lod_bias = bias;
    else
      lookup = {LookupKind::bias, bias, {}, {}};
    Draw draw = cells_draw(sampler, lookup);
    for (int column = 0; column < kAcross; ++column) {
      const double size = power_of_2(static_cast<double>(random.between(0, 5)));
      add_numbered_cell(draw, row * kAcross + column, {{size, 0}, {0, size}});
    }
    scene.draws.push_back(std::move(draw));
  }
  return scene;
}

// -------------------------------------------------------------------------------------------- bias

Lookup gradients_of(double texels) {
  const auto step = static_cast<float>(texels / kLarge.width);
  return {LookupKind::gradients, 0, {step, 0}, {0, step}};
}

Scene sampler_bias_scene(RandomSource& random, const TextureProbes& of) {
  Scene scene = textured_scene(of.surface, {kTarget, kTarget}, numbered_levels(kLarge));
  Sampler sampler = sampler_of(Filter::linear, Filter::linear, MipFilter::linear);
  for (std::size_t n = 0; n < kPoints; ++n) {
    sampler.lod_bias = static_cast<float>(grid_number(random, -2, 2, 13));
    const Lookup lookup =
        of.question == TextureQuestion::gradients_bias ? gradients_of(8) : lod_of(3);
    scene.draws.push_back(point_draw(n, kTarget, sampler, lookup, {0.5, 0.5}));
  }
  return scene;
}

// Tiny footprints with two large biases.
Scene bias_sum_scene(RandomSource& random, const TextureProbes& of) {
  Scene scene = textured_scene(of.surface, {kTarget, kTarget}, numbered_levels(kLarge));
  Sampler sampler = sampler_of(Filter::linear, Filter::linear, MipFilter::linear);
  for (int row = 0; row < kAcross; ++row) {
    sampler.lod_bias = static_cast<float>(random.between(12, 14));
    const Lookup lookup{LookupKind::bias, static_cast<float>(random.between(5, 7)), {}, {}};
    Draw draw = cells_draw(sampler, lookup);
    for (int column = 0; column < kAcross; ++column) {
      const double size = power_of_2(static_cast<double>(random.between(-15, -13)));
      add_numbered_cell(draw, row * kAcross + column, {{size, 0}, {0, size}});
    }
    scene.draws.push_back(std::move(draw));
  }
  return scene;
}

// -------------------------------------------------------------------------------- texels and wraps

// Alternating black and full columns.
Texture columns_of(TextureFormat format, ImageSize size, int levels) {
  const float most = full(format);
  return texture_of(format, size, levels,
                    [&](int, int i, int, int) { return i % 2 == 0 ? 0.0f : most; });
}

// One strip: across half a texel to two of them, or close to a border; with both filters.
Scene texel_grid_scene(RandomSource& random, const TextureProbes& of, std::uint64_t index) {
  constexpr ImageSize kStrip{256, 4};
  constexpr ImageSize kImage{4, 4};
  constexpr std::array kSpans{0.5, 1.0, 2.0, 0.3712158203125, 1.40625};
  const Filter filter = index % 3 == 2 ? Filter::nearest : Filter::linear;
  Scene scene = textured_scene(of.surface, kStrip, columns_of(of.format, kImage, 1));
  Sampler sampler = sampler_of(filter, filter, MipFilter::none);
  if (random.one_in(2)) sampler.wrap = {Wrap::clamp_to_edge, Wrap::clamp_to_edge};
  Draw draw = textured_draw(Primitive::triangles, sampler, {});
  double span = 0x1p-5;
  double first = static_cast<double>(random.between(1, 3)) - span / 2;
  if (filter == Filter::linear) {
    // In the first one every position is halfway between two steps.
    span = index == 0 ? 1 : random.one_of<double>(kSpans);
    first = 0.5 + (index == 0 ? 0 : unit(random));
  }
  for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
    draw.vertices.push_back(
        textured_vertex(right * kStrip.width, up * kStrip.height,
                        {(first + right * span) / kImage.width, 0.125 + up * 0.25}));
  scene.draws.push_back(std::move(draw));
  return scene;
}

// Seven images of four texels, with no pixel's centre on a border.
Scene wrap_scene(RandomSource& random, const TextureProbes& of) {
  const auto offset = static_cast<int>(random.below(4));
  Scene scene = textured_scene(
      of.surface, {kTarget, kTarget},
      texture_of(TextureFormat::rgba8, {4, 4}, 1, [&](int, int i, int j, int component) {
        return static_cast<float>(16 * ((4 * j + i + offset) % 16) + component);
      }));
  Sampler sampler = sampler_of(Filter::nearest, Filter::nearest, MipFilter::none);
  sampler.wrap = {Wrap::mirrored_repeat, Wrap::mirrored_repeat};
  Draw draw = textured_draw(Primitive::triangles, sampler, {});
  const double first = -3 - static_cast<double>(random.below(2));
  for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
    draw.vertices.push_back(
        textured_vertex(right * kTarget, up * kTarget, {first + right * 7, first + up * 7}));
  scene.draws.push_back(std::move(draw));
  return scene;
}

// The two filters differ a quarter of a texel off a centre. No level is halfway between two.
Scene crossover_scene(RandomSource& random, const TextureProbes& of) {
  Texture texture = columns_of(TextureFormat::rgba32f, {8, 8}, 0);
  for (std::size_t k = 1; k < texture.levels.size(); ++k)
    for (float& number : texture.levels[k].texels) number = 0.5f;
  Scene scene = textured_scene(of.surface, {kTarget, kTarget}, std::move(texture));
  for (std::size_t n = 0; n < kPoints; ++n) {
    const Sampler sampler = sampler_of(Filter::linear, Filter::nearest,
                                       n % 2 == 0 ? MipFilter::nearest : MipFilter::linear);
    const double level = n % 8 == 1 ? 0.5 : grid_number(random, -1, 1, 6) / 2;
    const double texel = static_cast<double>(random.below(8));
    scene.draws.push_back(
        point_draw(n, kTarget, sampler, lod_of(level), {(texel + 0.25) / 8, 0.5625}));
  }
  return scene;
}

// Ratios that are not whole numbers, at any angle.
Scene anisotropy_scene(RandomSource& random, const TextureProbes& of) {
  constexpr std::array kMost{2.0f, 4.0f, 8.0f, 16.0f};
  Scene scene = textured_scene(of.surface, {kTarget, kTarget}, numbered_levels(kLarge));
  Sampler sampler = sampler_of(Filter::linear, Filter::linear, MipFilter::linear);
  sampler.max_anisotropy = random.one_of<float>(kMost);
  Draw draw = cells_draw(sampler, {});
  for (int n = 0; n < kAcross * kAcross; ++n) {
    const double ratio = static_cast<double>(random.between(1, 9)) + 0.125 + unit(random) * 0.75;
    const double length = power_of_2(2 + 4 * unit(random));
    const double angle = 2 * std::numbers::pi * unit(random);
    const double c = cosine(angle);
    const double s = sine(angle);
    TexelSteps steps{{length * c, length * s}, {-length / ratio * s, length / ratio * c}};
    if (random.one_in(2)) std::swap(steps.dx, steps.dy);
    add_numbered_cell(draw, n, steps);
  }
  scene.draws.push_back(std::move(draw));
  return scene;
}

}  // namespace

Scene texture_probe(const TextureProbes& of, std::uint64_t index) {
  RandomSource random(of.seed, stream_of(of), index);
  switch (of.question) {
    case TextureQuestion::level_weight:
      break;
    case TextureQuestion::texel_grid:
      return texel_grid_scene(random, of, index);
    case TextureQuestion::wrap:
      return wrap_scene(random, of);
    case TextureQuestion::implicit_tie:
      return implicit_tie_scene(random, of);
    case TextureQuestion::bias_tie:
      return bias_tie_scene(random, of);
    case TextureQuestion::explicit_tie:
      return explicit_tie_scene(random, of);
    case TextureQuestion::crossover:
      return crossover_scene(random, of);
    case TextureQuestion::sampler_bias:
    case TextureQuestion::gradients_bias:
      return sampler_bias_scene(random, of);
    case TextureQuestion::bias_sum:
      return bias_sum_scene(random, of);
    case TextureQuestion::anisotropy:
      return anisotropy_scene(random, of);
  }
  return level_weight_scene(random, of);
}

Scene chain_scene(std::uint64_t seed, Surface surface, TextureFormat format, std::uint64_t index) {
  RandomSource random(
      seed, kChainStreams + window_streams(surface) + static_cast<std::uint64_t>(format), index);
  constexpr std::array<ImageSize, 7> kFirst{
      {{16, 16}, {7, 7}, {16, 4}, {5, 1}, {6, 10}, {13, 3}, {9, 9}}};
  const ImageSize size = index < kFirst.size() ? kFirst[index]
                                               : ImageSize{static_cast<int>(random.between(2, 24)),
                                                           static_cast<int>(random.between(1, 24))};
  const bool is_float = holds_floats(format);
  Texture texture = texture_of(format, size, 1, [&](int, int, int, int) {
    return is_float ? static_cast<float>(unit(random)) : static_cast<float>(random.below(256));
  });
  texture.generated = true;
  Scene scene = textured_scene(surface, {4, 4}, std::move(texture));
  Draw draw = textured_draw(Primitive::triangles,
                            sampler_of(Filter::linear, Filter::linear, MipFilter::linear), {});
  for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}})
    draw.vertices.push_back(textured_vertex(4 * right, 4 * up, {1.0 * right, 1.0 * up}));
  add_draw(scene, std::move(draw));
  return scene;
}

}  // namespace edgecase
