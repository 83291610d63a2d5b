// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "exact/elementary.h"
#include "generate/random_shapes.h"
#include "generate/texture_parts.h"
#include "generate/texture_scenes.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kStreams = 0x410;  // plus a RampKind
constexpr int kCell = 4;                   // pixels

std::uint64_t stream_of(const Ramps& of) {
  return kStreams + window_streams(of.surface) + static_cast<std::uint64_t>(of.kind);
}

// Powers of two, unequal sides, sizes that halve unevenly, one dimension.
constexpr std::array<ImageSize, 5> kSizes{{{64, 64}, {64, 64}, {64, 16}, {48, 20}, {64, 1}}};

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
      steps = turned(length, 1, 2 * kPi * random.fraction());
      break;
    case RampKind::anisotropic: {
      const double ratio = power_of_2(static_cast<double>(random.between(1, 4)));
      steps = turned(length, ratio, 2 * kPi * random.fraction());
      if (random.one_in(2)) std::swap(steps.dx, steps.dy);
      break;
    }
    case RampKind::axis_aligned:
    case RampKind::magnification:
    case RampKind::perspective: {
      const double shorter = random.one_in(2) ? length : length * (0.5 + random.fraction() / 2);
      steps = {{random_sign(random) * length, 0}, {0, random_sign(random) * shorter}};
      if (random.one_in(2)) steps = swapped(steps);
      break;
    }
  }
  return steps;
}

// Cells in rows, with levels that rise from the first to the last.
void add_cells(RandomSource& random, RampKind kind, ImageSize size, Draw& draw) {
  constexpr int kAcross = kTextureTarget / kCell;
  constexpr int kCells = kAcross * kAcross;
  const double last = level_count(size.width, size.height) - 1;
  const double low = kind == RampKind::magnification ? -4 : -0.5;
  const double high = kind == RampKind::magnification ? last + 2 : last + 0.5;
  for (int n = 0; n < kCells; ++n) {
    const double level = low + (high - low) * (n + random.fraction()) / kCells;
    const TexelSteps steps = steps_of(random, kind, power_of_2(level));
    const double reach = kCell * power_of_2(level);
    const std::array<double, 2> origin{(random.fraction() - 0.5) * reach / size.width,
                                       (random.fraction() - 0.5) * reach / size.height};
    add_cell(draw, {n % kAcross * kCell, n / kAcross * kCell, kCell}, origin, steps, size);
  }
}

// A plane seen at a slant: w grows along one axis or both, by up to 8 times along each.
void add_floor(RandomSource& random, bool along_both, ImageSize size, Draw& draw) {
  const auto octaves_x = static_cast<int>(random.between(along_both ? 1 : 0, 3));
  const auto octaves_y = static_cast<int>(random.between(along_both || octaves_x == 0 ? 2 : 0, 3));
  const bool from_right = random.one_in(2);
  const bool from_top = random.one_in(2);
  const double repeats = power_of_2(4 * random.fraction());
  const double angle = random.one_in(2) ? 0 : 2 * std::numbers::pi * random.fraction();
  const auto corner = [&](int right, int up) {
    const double w = power_of_2(octaves_x * (from_right ? 1 - right : right) +
                                octaves_y * (from_top ? 1 - up : up));
    // Distant parts of the plane are wider by w.
    const double wide = (right - 0.5) * w;
    const double deep = (up - 0.5) * w;
    const double s = wide * cosine(angle) - deep * sine(angle);
    const double t = wide * sine(angle) + deep * cosine(angle);
    const double scale = repeats * std::max(size.width, size.height) / 8;
    Vertex vertex = textured_vertex(right * kTextureTarget, up * kTextureTarget,
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
  Scene scene = textured_scene(of.surface, numbered_levels(size));
  Draw draw = textured_draw(Primitive::triangles,
                            sampler_of(Filter::linear, Filter::linear, MipFilter::linear), {});
  if (of.kind == RampKind::perspective)
    add_floor(random, index == 0, size, draw);
  else
    add_cells(random, of.kind, size, draw);
  if (size.height == 1)
    for (Vertex& vertex : draw.vertices) vertex.texture_coordinates[1] = 0;
  scene.draws.push_back(std::move(draw));
  return scene;
}

}  // namespace edgecase
