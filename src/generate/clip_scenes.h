// SPDX-License-Identifier: MIT
//
// Random triangles that leave the clip volume in one way each: at the sides by little, by much and
// beyond any guard band, at near, at far, and behind the eye.
#pragma once

#include <array>
#include <cstdint>

#include "model/names.h"
#include "model/scene.h"

namespace edgecase {

// Where triangles leave the clip volume.
enum class ClipPlace {
  little,       // at the sides, up to 8 pixels beyond
  much,         // 64 to 2,048 pixels beyond
  beyond_8192,  // 8,192 to 32,768 pixels
  near,
  far,
  behind,  // a vertex behind the eye
};
template <>
inline constexpr auto kNames<ClipPlace> =
    std::to_array<Named<ClipPlace>>({{ClipPlace::little, "little"},
                                     {ClipPlace::much, "much"},
                                     {ClipPlace::beyond_8192, "beyond-8192"},
                                     {ClipPlace::near, "near"},
                                     {ClipPlace::far, "far"},
                                     {ClipPlace::behind, "behind"}});

// One triangle with two vertices in the volume, on multiples of 1/16 pixel, so that no snapping
// moves them; a renderer snaps only the vertices that clipping makes.
Scene clip_scene(std::uint64_t seed, Surface surface, ClipPlace place, std::uint64_t index);

}  // namespace edgecase
