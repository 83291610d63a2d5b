// SPDX-License-Identifier: MIT
//
// Scenes by which texturing is measured.
//
// Each is a function of its seed and index alone, as those of generate/random_scenes.h are.
// Vertices lie on whole pixels, or points on pixels' centres, so that no snapping moves them; where
// a question is about ties, texture coordinates are short binary fractions.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "generate/random_source.h"
#include "model/names.h"
#include "model/scene.h"

namespace edgecase {

// --------------------------------------------------------------------------------------- questions

// What a scene asks about; all else that could matter is held constant.
enum class TextureQuestion {
  level_weight,    // the weight of the second level, at levels that the shader gives
  texel_grid,      // texels, and their weights, across a texel or a border
  wrap,            // mirrored repetition
  implicit_tie,    // the nearest level where footprints make a tie
  bias_tie,        // where a bias makes it
  explicit_tie,    // where the shader gives it
  crossover,       // filters just beyond a level of 0
  sampler_bias,    // the sampler's bias, of levels that the shader gives
  gradients_bias,  // the same, of gradients
  bias_sum,        // both biases, together beyond what they may be
  anisotropy,      // levels of elongated footprints
};

struct TextureProbes {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  TextureQuestion question = TextureQuestion::level_weight;
  TextureFormat format = TextureFormat::rgba8;  // of the first two questions; others have their own
};
Scene texture_probe(const TextureProbes& of, std::uint64_t index);

// A texture whose levels the renderer generates, of sizes even, odd and very unlike.
Scene chain_scene(std::uint64_t seed, Surface surface, TextureFormat format, std::uint64_t index);

// ------------------------------------------------------------------------------------------- ramps

// Footprints whose levels rise over the target. A ramp has a texture of floats with one flat colour
// per level, red the level's number, and blends the two nearest: so what is looked up tells the
// level of detail, as textureQueryLod does.
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

// Scenes of different purpose have nothing in common.
enum class RampPurpose { traits, residuals };

struct Ramps {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  RampKind kind = RampKind::axis_aligned;
  RampPurpose purpose = RampPurpose::residuals;
};
Scene ramp_scene(const Ramps& of, std::uint64_t index);

// ------------------------------------------------------------------------------- parts of scenes

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
  return holds_floats(format) ? 1.0f : 255.0f;
}

// A target with one texture, without draws; details of lookups are asked for.
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
