// SPDX-License-Identifier: MIT
//
// The measurement of clipping on one surface: random triangles that leave the clip volume at one
// place each, at the sides by little, by much and beyond any guard band, at near, at far, and
// behind the eye.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/renderer.h"
#include "profile/observation.h"
#include "profile/profile.h"
#include "profile/scene_drawing.h"
#include "rules/choices.h"

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
constexpr int kClipPlaces = 6;
const char* name_of(ClipPlace place);

// One triangle, two of its vertices in the volume. Those within it lie on multiples of 1/16 pixel,
// so that no snapping moves them; what a renderer snaps are vertices that it makes.
Scene clip_scene(std::uint64_t seed, Surface surface, ClipPlace place, std::uint64_t index);

struct ClipFindings {
  std::vector<Trait> traits;
  Choices choices;  // of clip.volume, where an alternative fits
  DrawnCounts drawn;
};

struct ClipMeasureQuestion {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  std::size_t scenes_per_kind = 20'000;  // as in MeasureOptions; a hundredth is drawn of each place
  CoverageChoice triangles;              // as found so far
};

std::size_t clip_scene_count(std::size_t scenes_per_kind);

// clip.volume of each place, by the coverage that its alternatives yield of whole triangles, and of
// all of them.
ClipFindings measure_clipping(Renderer& renderer, const ClipMeasureQuestion& question,
                              const ObservationProgress& progress, const std::atomic<bool>* stop);

}  // namespace edgecase
