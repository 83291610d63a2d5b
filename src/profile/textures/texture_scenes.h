// SPDX-License-Identifier: MIT
//
// Scenes for measuring textures.
//
// Each depends only on its seed and index, like those of generate/random_scenes.h. Vertices lie on
// whole pixels, or points on pixels' centres, so that no snapping moves them; for questions about
// ties, texture coordinates are short binary fractions.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "generate/random_source.h"
#include "model/names.h"
#include "model/scene.h"

namespace edgecase {

// --------------------------------------------------------------------------------------- questions

// The question of a scene; everything else that could matter is constant.
enum class TextureQuestion {
  level_weight,    // the weight of the second level, at levels given by the shader
  texel_grid,      // texels, and their weights, across a texel or a border
  wrap,            // mirrored repetition
  implicit_tie,    // the nearest level, with ties made by footprints
  bias_tie,        // ... by a bias
  explicit_tie,    // ... by the shader
  crossover,       // filters just beyond a level of 0
  sampler_bias,    // the sampler's bias, for levels given by the shader
  gradients_bias,  // the same, for gradients
  bias_sum,        // both biases, together beyond their limit
  anisotropy,      // levels of elongated footprints
};

struct TextureProbes {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  TextureQuestion question = TextureQuestion::level_weight;
  TextureFormat format = TextureFormat::rgba8;  // of the first two questions; others have their own
};
Scene texture_probe(const TextureProbes& of, std::uint64_t index);

// A texture with generated levels, of even, odd and very unequal sizes.
Scene chain_scene(std::uint64_t seed, Surface surface, TextureFormat format, std::uint64_t index);

// ------------------------------------------------------------------------------------------- ramps

// Footprints whose levels rise over the target. A ramp has a texture of floats with one flat colour
// per level, with red the level's number, and blends the two nearest: so the lookup shows the level
// of detail, as textureQueryLod does.
enum class RampKind {
  axis_aligned,   // u along x and v along y, or swapped
  diagonal,       // along both
  rotated,        // by any angle
  anisotropic,    // 2:1 to 16:1, by any angle
  perspective,    // a floor: w differs
  magnification,  // from levels far below 0 to beyond the last
};
template <>
inline constexpr auto kNames<RampKind> =
    std::to_array<Named<RampKind>>({{RampKind::axis_aligned, "axis-aligned"},
                                    {RampKind::diagonal, "diagonal"},
                                    {RampKind::rotated, "rotated"},
                                    {RampKind::anisotropic, "anisotropic"},
                                    {RampKind::perspective, "perspective"},
                                    {RampKind::magnification, "magnification"}});

// Scenes of different purposes are independent.
enum class RampPurpose { traits, residuals };

struct Ramps {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  RampKind kind = RampKind::axis_aligned;
  RampPurpose purpose = RampPurpose::residuals;
};
Scene ramp_scene(const Ramps& of, std::uint64_t index);

// ------------------------------------------------------------------------------- parts of scenes

// Texels of the base level per pixel along x and along y.
struct TexelSteps {
  std::array<double, 2> dx{};  // du/dx and dv/dx
  std::array<double, 2> dy{};
};

struct ImageSize {
  int width = 1;
  int height = 1;
};

// A component of a level's texel: code or number, as the format stores it.
using TexelNumber = std::function<float(int level, int i, int j, int component)>;

// A texture with this number of levels; 0: a whole chain.
Texture texture_of(TextureFormat format, ImageSize size, int levels, const TexelNumber& number);

// A whole chain of floats: red is the level's number.
Texture numbered_levels(ImageSize size);

// The number that stands for 1 in a format.
constexpr float full(TextureFormat format) {
  return holds_floats(format) ? 1.0f : 255.0f;
}

// A target with one texture and without draws; requests details of lookups.
Scene textured_scene(Surface surface, ImageSize target, Texture texture);

Draw textured_draw(Primitive primitive, const Sampler& sampler, const Lookup& lookup);

// The default sampler of the questions: all filters nearest, the levels blended or not.
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

// Adds a draw; if the texture has one dimension, t becomes 0 everywhere.
void add_draw(Scene& scene, Draw draw);

// A point of one pixel, the n-th of a target of that width.
Draw point_draw(std::size_t n, int target_width, const Sampler& sampler, const Lookup& lookup,
                std::array<double, 2> coordinates);

// From 0 to 1, with 24 bits.
double unit(RandomSource& random);

}  // namespace edgecase
