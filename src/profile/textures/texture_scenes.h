// SPDX-License-Identifier: MIT
//
// Scenes by which texturing is measured.
//
// Each is a function of its seed and index alone, as those of generate/random_scenes.h are.
// Vertices lie on whole pixels, or points on pixels' centres, so that no snapping moves them; where
// a question is about ties, texture coordinates are short binary fractions.
#pragma once

#include <cstdint>
#include <span>

#include "model/scene.h"

namespace edgecase {

// --------------------------------------------------------------------------------------- questions

// What a scene tells apart; what else could matter is held still.
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
std::span<const RampKind> all_ramp_kinds();
const char* name_of(RampKind kind);

// Scenes of different purpose have nothing in common.
enum class RampPurpose { traits, residuals };

struct Ramps {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  RampKind kind = RampKind::axis_aligned;
  RampPurpose purpose = RampPurpose::residuals;
};
Scene ramp_scene(const Ramps& of, std::uint64_t index);

}  // namespace edgecase
