// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "exact/elementary.h"
#include "generate/random_shapes.h"
#include "profile/textures/textures.h"

namespace edgecase {

Texture texture_of(TextureFormat format, ImageSize size, int levels, const TexelNumber& number) {
  Texture texture;
  texture.dimensions = size.height == 1 ? 1 : 2;
  texture.format = format;
  const int count = levels == 0 ? level_count(size.width, size.height) : levels;
  for (int k = 0; k < count; ++k) {
    TextureLevel level{level_size(size.width, k), level_size(size.height, k), {}};
    for (int j = 0; j < level.height; ++j)
      for (int i = 0; i < level.width; ++i)
        for (int c = 0; c < 4; ++c) level.texels.push_back(number(k, i, j, c));
    texture.levels.push_back(std::move(level));
  }
  return texture;
}

Texture numbered_levels(ImageSize size) {
  return texture_of(TextureFormat::rgba32f, size, 0, [](int level, int, int, int component) {
    return component == 0 ? static_cast<float>(level) : 1.0f;
  });
}

Scene textured_scene(Surface surface, ImageSize target, Texture texture) {
  Scene scene = empty_scene(surface, target.width);
  scene.target.height = target.height;
  // Vertices on the target's edges lie inside it.
  scene.viewport = {-target.width / 2, -target.height / 2, 2 * target.width, 2 * target.height};
  scene.details.texture = true;
  scene.textures.push_back(std::make_shared<const Texture>(std::move(texture)));
  return scene;
}

Draw textured_draw(Primitive primitive, const Sampler& sampler, const Lookup& lookup) {
  Draw draw;
  draw.primitive = primitive;
  draw.interpolation = Interpolation::smooth;
  draw.texture = TextureUse{0, sampler, lookup};
  return draw;
}

Sampler sampler_of(Filter magnify, Filter minify, MipFilter mipmap) {
  Sampler sampler;
  sampler.magnify = magnify;
  sampler.minify = minify;
  sampler.mipmap = mipmap;
  return sampler;
}

Vertex textured_vertex(double x, double y, std::array<double, 2> coordinates) {
  Vertex vertex;
  vertex.position =
      in_sixteenths(static_cast<std::int64_t>(16 * x), static_cast<std::int64_t>(16 * y));
  vertex.texture_coordinates = {static_cast<float>(coordinates[0]),
                                static_cast<float>(coordinates[1])};
  return vertex;
}

void add_cell(Draw& draw, const Cell& cell, std::array<double, 2> origin, const TexelSteps& steps,
              ImageSize texture) {
  const auto corner = [&](int right, int up) {
    const double across = right * cell.side;
    const double above = up * cell.side;
    return textured_vertex(
        cell.x + across, cell.y + above,
        {origin[0] + (across * steps.dx[0] + above * steps.dy[0]) / texture.width,
         origin[1] + (across * steps.dx[1] + above * steps.dy[1]) / texture.height});
  };
  for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
    draw.vertices.push_back(corner(right, up));
}

void add_draw(Scene& scene, Draw draw) {
  if (scene.textures[0]->dimensions == 1)
    for (Vertex& vertex : draw.vertices) vertex.texture_coordinates[1] = 0;
  scene.draws.push_back(std::move(draw));
}

Draw point_draw(std::size_t n, int target_width, const Sampler& sampler, const Lookup& lookup,
                std::array<double, 2> coordinates) {
  Draw draw = textured_draw(Primitive::points, sampler, lookup);
  const int at = static_cast<int>(n);
  draw.vertices.push_back(
      textured_vertex(at % target_width + 0.5, at / target_width + 0.5, coordinates));
  return draw;
}

double unit(RandomSource& random) {
  return static_cast<double>(random.below(1 << 24)) * 0x1p-24;
}

namespace {

constexpr std::uint64_t kRampStreams = 0x400;
// Windows have different scenes, so that both surfaces together show more.
constexpr std::uint64_t kWindowStreams = 0x1000;

constexpr int kTarget = 32;  // pixels
constexpr int kCell = 4;

std::uint64_t stream_of(const Ramps& of) {
  return kRampStreams + (of.surface == Surface::window ? kWindowStreams : 0) +
         16 * static_cast<std::uint64_t>(of.purpose) + static_cast<std::uint64_t>(of.kind);
}

// Powers of two, unequal sides, sizes that halve unevenly, one dimension.
constexpr std::array<ImageSize, 5> kSizes{{{64, 64}, {64, 64}, {64, 16}, {48, 20}, {64, 1}}};

double random_sign(RandomSource& random) {
  return static_cast<double>(random.sign());
}

TexelSteps swapped(const TexelSteps& steps) {
  return {{steps.dx[1], steps.dx[0]}, {steps.dy[1], steps.dy[0]}};
}

// The axes of an ellipse, with the first `ratio` times as long, turned by an angle.
TexelSteps turned(double length, double ratio, double angle) {
  const double c = cosine(angle);
  const double s = sine(angle);
  return {{length * c, length * s}, {-length / ratio * s, length / ratio * c}};
}

// Vectors, the longer of which has this length.
TexelSteps steps_of(RandomSource& random, RampKind kind, double length) {
  constexpr double kPi = std::numbers::pi;
  TexelSteps steps;
  switch (kind) {
    case RampKind::diagonal:
      steps = turned(length, 1, kPi / 4 * (1 + 2 * static_cast<double>(random.below(4))));
      break;
    case RampKind::rotated:
      steps = turned(length, 1, 2 * kPi * unit(random));
      break;
    case RampKind::anisotropic: {
      const double ratio = power_of_2(static_cast<double>(random.between(1, 4)));
      steps = turned(length, ratio, 2 * kPi * unit(random));
      if (random.one_in(2)) std::swap(steps.dx, steps.dy);
      break;
    }
    case RampKind::axis_aligned:
    case RampKind::magnification:
    case RampKind::perspective: {
      const double shorter = random.one_in(2) ? length : length * (0.5 + unit(random) / 2);
      steps = {{random_sign(random) * length, 0}, {0, random_sign(random) * shorter}};
      if (random.one_in(2)) steps = swapped(steps);
      break;
    }
  }
  return steps;
}

// Cells in rows, with levels that rise from the first to the last.
void add_cells(RandomSource& random, RampKind kind, ImageSize size, Draw& draw) {
  constexpr int kAcross = kTarget / kCell;
  constexpr int kCells = kAcross * kAcross;
  const double last = level_count(size.width, size.height) - 1;
  const double low = kind == RampKind::magnification ? -4 : -0.5;
  const double high = kind == RampKind::magnification ? last + 2 : last + 0.5;
  for (int n = 0; n < kCells; ++n) {
    const double level = low + (high - low) * (n + unit(random)) / kCells;
    const TexelSteps steps = steps_of(random, kind, power_of_2(level));
    const double reach = kCell * power_of_2(level);
    const std::array<double, 2> origin{(unit(random) - 0.5) * reach / size.width,
                                       (unit(random) - 0.5) * reach / size.height};
    add_cell(draw, {n % kAcross * kCell, n / kAcross * kCell, kCell}, origin, steps, size);
  }
}

// A plane seen at a slant: w grows along one axis or both, by up to 8 times along each.
void add_floor(RandomSource& random, bool along_both, ImageSize size, Draw& draw) {
  const auto octaves_x = static_cast<int>(random.between(along_both ? 1 : 0, 3));
  const auto octaves_y = static_cast<int>(random.between(along_both || octaves_x == 0 ? 2 : 0, 3));
  const bool from_right = random.one_in(2);
  const bool from_top = random.one_in(2);
  const double repeats = power_of_2(4 * unit(random));
  const double angle = random.one_in(2) ? 0 : 2 * std::numbers::pi * unit(random);
  const auto corner = [&](int right, int up) {
    const double w = power_of_2(octaves_x * (from_right ? 1 - right : right) +
                                octaves_y * (from_top ? 1 - up : up));
    // Distant parts of the plane are wider by w.
    const double wide = (right - 0.5) * w;
    const double deep = (up - 0.5) * w;
    const double s = wide * cosine(angle) - deep * sine(angle);
    const double t = wide * sine(angle) + deep * cosine(angle);
    const double scale = repeats * std::max(size.width, size.height) / 8;
    Vertex vertex = textured_vertex(right * kTarget, up * kTarget,
                                    {scale * s / size.width, scale * t / size.height});
    vertex.w = static_cast<float>(w);
    return vertex;
  };
  for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
    draw.vertices.push_back(corner(right, up));
}

}  // namespace

Scene ramp_scene(const Ramps& of, std::uint64_t index) {
  RandomSource random(of.seed, stream_of(of), index);
  // The first scene of each kind is square, and that of a floor rises along both axes.
  const ImageSize size = index == 0 ? kSizes[0] : random.one_of<ImageSize>(kSizes);
  Scene scene = textured_scene(of.surface, {kTarget, kTarget}, numbered_levels(size));
  Draw draw = textured_draw(Primitive::triangles,
                            sampler_of(Filter::linear, Filter::linear, MipFilter::linear), {});
  if (of.kind == RampKind::perspective)
    add_floor(random, index == 0, size, draw);
  else
    add_cells(random, of.kind, size, draw);
  add_draw(scene, std::move(draw));
  return scene;
}

}  // namespace edgecase
