// SPDX-License-Identifier: MIT
//
// Colours that are stored, masked and blended.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "generate/random_shapes.h"
#include "profile/output/output.h"

namespace edgecase {

RandomSource random_of(std::uint64_t seed, OutputStream stream, Surface surface,
                       std::uint64_t index) {
  // Windows have different scenes, so that both surfaces together show more.
  constexpr std::uint64_t kWindowStreams = 0x1000;
  return {seed,
          static_cast<std::uint64_t>(stream) + (surface == Surface::window ? kWindowStreams : 0),
          index};
}

Scene cell_scene(Surface surface) {
  return empty_scene(surface, kCellColumns);
}

Draw cell_draw() {
  Draw draw;
  draw.primitive = Primitive::triangles;
  draw.interpolation = Interpolation::flat;
  return draw;
}

void add_triangle(Draw& draw, std::size_t cell, const CellTriangle& triangle) {
  const auto column = static_cast<std::int64_t>(cell % kCellColumns);
  const auto row = static_cast<std::int64_t>(cell / kCellColumns);
  constexpr std::array<std::array<std::int64_t, 2>, 3> kQuarters{{{1, 1}, {3, 1}, {2, 3}}};
  std::array<Vertex, 3> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i].position = {Fixed::from_raw((4 * column + kQuarters[i][0]) * Fixed::kOne / 4),
                           Fixed::from_raw((4 * row + kQuarters[i][1]) * Fixed::kOne / 4)};
    corners[i].z = triangle.z[i];
    corners[i].color = triangle.color;
  }
  if (!triangle.front_facing) std::swap(corners[0], corners[1]);
  draw.vertices.insert(draw.vertices.end(), corners.begin(), corners.end());
}

CellTriangle flat_triangle(const Color& color, std::int64_t depth, bool front_facing) {
  const Fixed z = z_of_depth(depth);
  return {color, {z, z, z}, front_facing};
}

PixelPosition cell_pixel(const ScenePrimitive& primitive) {
  const Point corner = primitive.vertices[0]->position;
  return {static_cast<int>(corner.x.floor()), static_cast<int>(corner.y.floor())};
}

float code_color(std::int64_t code) {
  return static_cast<float>(code) / 255.0F;
}

Color random_codes(RandomSource& random) {
  Color color;
  for (float& component : color) component = code_color(random.below(256));
  return color;
}

namespace {

constexpr std::int64_t kCodes = 256;
constexpr std::uint64_t kScenesOfAFactor = 4;  // of the destination
constexpr std::uint64_t kMinMaxScenes = 2;
constexpr std::uint64_t kOverScenes = 24;
constexpr std::size_t kMasks = 16;

constexpr std::array kFactors{BlendFactor::zero,
                              BlendFactor::one,
                              BlendFactor::src_color,
                              BlendFactor::one_minus_src_color,
                              BlendFactor::dst_color,
                              BlendFactor::one_minus_dst_color,
                              BlendFactor::src_alpha,
                              BlendFactor::one_minus_src_alpha,
                              BlendFactor::dst_alpha,
                              BlendFactor::one_minus_dst_alpha,
                              BlendFactor::constant_color,
                              BlendFactor::one_minus_constant_color,
                              BlendFactor::constant_alpha,
                              BlendFactor::one_minus_constant_alpha,
                              BlendFactor::src_alpha_saturate};
// Those that use factors.
constexpr std::array kEquations{BlendEquation::add, BlendEquation::subtract,
                                BlendEquation::reverse_subtract};
constexpr std::size_t kTerms =
    kEquations.size() * kFactors.size();  // per factor of the destination
constexpr std::size_t kCellsOfATerm = kCells / kTerms;

std::vector<float> plain_values() {
  std::vector<float> values{-1, -0x1p-10F, 0x1p-20F, 1 + 0x1p-20F, 2, 255};
  for (std::int64_t i = 0; i <= kCodes; ++i)
    values.push_back(static_cast<float>(i) / static_cast<float>(kCodes));
  for (std::int64_t code = 0; code + 1 < kCodes; ++code) {
    const float border = static_cast<float>(2 * code + 1) / 510.0F;
    for (const float value : {std::nextafter(border, 0.0F), border, std::nextafter(border, 1.0F)})
      values.push_back(value);
  }
  return values;
}

// A scene in which each cell already has a random code.
Scene stored_codes(RandomSource& random, Surface surface) {
  Scene scene = cell_scene(surface);
  Draw draw = cell_draw();
  for (std::size_t cell = 0; cell < kCells; ++cell)
    add_triangle(draw, cell, flat_triangle(random_codes(random), 0));
  scene.draws.push_back(std::move(draw));
  return scene;
}

void add_blended(Scene& scene, RandomSource& random, const Blending& blending, std::size_t first,
                 std::size_t count) {
  Draw draw = cell_draw();
  draw.operations.blending = blending;
  for (std::size_t cell = first; cell < first + count; ++cell)
    add_triangle(draw, cell, flat_triangle(random_color(random), 0));
  scene.draws.push_back(std::move(draw));
}

Scene terms_scene(RandomSource& random, Surface surface, BlendFactor destination) {
  Scene scene = stored_codes(random, surface);
  for (std::size_t term = 0; term < kTerms; ++term) {
    Blending blending;
    blending.color = {kEquations[term / kFactors.size()], kFactors[term % kFactors.size()],
                      destination};
    blending.alpha = {random.one_of(std::span<const BlendEquation>(kEquations)),
                      random.one_of(std::span<const BlendFactor>(kFactors)), destination};
    for (float& component : blending.constant) component = random_color_component(random);
    add_blended(scene, random, blending, term * kCellsOfATerm, kCellsOfATerm);
  }
  return scene;
}

Scene min_max_scene(RandomSource& random, Surface surface) {
  Scene scene = stored_codes(random, surface);
  // Factors that must be ignored.
  const BlendTerm least{BlendEquation::min, BlendFactor::one_minus_src_alpha, BlendFactor::one};
  const BlendTerm most{BlendEquation::max, BlendFactor::one_minus_src_alpha, BlendFactor::one};
  add_blended(scene, random, {least, most, {}}, 0, kCells / 2);
  add_blended(scene, random, {most, least, {}}, kCells / 2, kCells / 2);
  return scene;
}

// Premultiplied or not.
Scene over_scene(RandomSource& random, Surface surface, bool is_premultiplied) {
  Scene scene = stored_codes(random, surface);
  const BlendFactor source = is_premultiplied ? BlendFactor::one : BlendFactor::src_alpha;
  const BlendTerm over{BlendEquation::add, source, BlendFactor::one_minus_src_alpha};
  Draw draw = cell_draw();
  draw.operations.blending = Blending{over, over, {}};
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    Color color = random_color(random);
    color[3] = code_color(static_cast<std::int64_t>(cell));
    if (is_premultiplied)
      for (std::size_t i = 0; i < 3; ++i) color[i] *= color[3];
    add_triangle(draw, cell, flat_triangle(color, 0));
  }
  scene.draws.push_back(std::move(draw));
  return scene;
}

}  // namespace

std::vector<Scene> plain_color_scenes(Surface surface) {
  const std::vector<float> values = plain_values();
  std::vector<Scene> scenes;
  for (std::size_t from = 0; from < values.size(); from += 4 * kCells) {
    Scene scene = cell_scene(surface);
    Draw draw = cell_draw();
    for (std::size_t cell = 0; cell < kCells && from + 4 * cell < values.size(); ++cell) {
      Color color{};
      for (std::size_t i = 0; i < 4; ++i)
        color[i] = values[std::min(from + 4 * cell + i, values.size() - 1)];
      add_triangle(draw, cell, flat_triangle(color, 0));
    }
    scene.draws.push_back(std::move(draw));
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::vector<Scene> color_mask_scenes(std::uint64_t seed, Surface surface) {
  std::vector<Scene> scenes;
  for (const bool blends : {false, true}) {
    RandomSource random = random_of(seed, OutputStream::masks, surface, scenes.size());
    Scene scene = stored_codes(random, surface);
    constexpr std::size_t kOfAMask = kCells / kMasks;
    for (std::size_t mask = 0; mask < kMasks; ++mask) {
      Draw draw = cell_draw();
      for (std::size_t i = 0; i < 4; ++i) draw.operations.color_mask[i] = (mask >> i & 1) != 0;
      if (blends)
        draw.operations.blending =
            Blending{{BlendEquation::add, BlendFactor::one, BlendFactor::one},
                     {BlendEquation::add, BlendFactor::one, BlendFactor::one},
                     {}};
      for (std::size_t cell = mask * kOfAMask; cell < (mask + 1) * kOfAMask; ++cell)
        add_triangle(draw, cell, flat_triangle(random_codes(random), 0));
      scene.draws.push_back(std::move(draw));
    }
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::vector<Scene> blend_scenes(std::uint64_t seed, Surface surface) {
  std::vector<Scene> scenes;
  const auto next = [&] { return random_of(seed, OutputStream::blends, surface, scenes.size()); };
  for (std::uint64_t i = 0; i < kOverScenes; ++i) {
    RandomSource random = next();
    scenes.push_back(over_scene(random, surface, i % 2 == 1));
  }
  for (std::uint64_t i = 0; i < kMinMaxScenes; ++i) {
    RandomSource random = next();
    scenes.push_back(min_max_scene(random, surface));
  }
  for (const BlendFactor destination : kFactors)
    for (std::uint64_t i = 0; i < kScenesOfAFactor; ++i) {
      RandomSource random = next();
      scenes.push_back(terms_scene(random, surface, destination));
    }
  return scenes;
}

}  // namespace edgecase
