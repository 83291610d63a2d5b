// SPDX-License-Identifier: MIT
//
// Random scenes of textures whose levels of detail lie at ties of levels, at the crossover of
// filters, and on ramps.
//
// Each depends only on its seed and index, like those of generate/random_scenes.h. Vertices lie on
// whole pixels, or points on pixels' centres, so that no snapping moves them; for questions about
// ties, texture coordinates are short binary fractions.
#pragma once

#include <array>
#include <cstdint>

#include "model/names.h"
#include "model/scene.h"

namespace edgecase {

// The question of a scene; everything else that could matter is constant.
enum class TextureQuestion {
  implicit_tie,  // the nearest level, with ties made by footprints
  bias_tie,      // ... by a bias
  explicit_tie,  // ... by the shader
  crossover,     // filters just beyond a level of 0
};

struct TextureProbes {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  TextureQuestion question = TextureQuestion::implicit_tie;
};
Scene texture_probe(const TextureProbes& of, std::uint64_t index);

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

struct Ramps {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  RampKind kind = RampKind::axis_aligned;
};
Scene ramp_scene(const Ramps& of, std::uint64_t index);

}  // namespace edgecase
