// SPDX-License-Identifier: MIT
//
// FastTextures: a scene's textures as kernels look them up, and where they can.
//
// They can where no vertex's w differs, so that one level of detail holds for all pixels of a
// triangle: the plain stages say which, once. Linear filters of RGBA8 texels whose images have
// sides of powers of two, repeated or clamped to the edge; everything else is left to the plain
// stages.
#pragma once

#include <deque>
#include <map>
#include <optional>

#include "kernels/color_planes.h"
#include "raster/texture_stage.h"

namespace edgecase {

class FastTextures {
 public:
  // Both must outlive it.
  FastTextures(const Scene& scene, const RuleChoices& choices);

  const TextureStage& stage() const { return stage_; }

  // What a triangle of a textured draw looks up, all of it but its positions. No vertex's w
  // differs, or none is divided by. Nothing where the plain stages have to look up. The planes live
  // as long as this does.
  std::optional<TexturedTriangle> looked_up(const ScenePrimitive& triangle);

 private:
  const TexelPlane* plane_of(std::size_t texture, int level);

  const Scene& scene_;
  const RuleChoices& choices_;
  TextureStage stage_;
  std::deque<std::vector<PixelWord>> words_;
  std::map<std::pair<std::size_t, int>, std::optional<TexelPlane>> planes_;
};

}  // namespace edgecase
