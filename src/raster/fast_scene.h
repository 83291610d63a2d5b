// SPDX-License-Identifier: MIT
//
// What the kernels draw: textures and a scene, made ready for them.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "kernels/color_planes.h"
#include "kernels/pixel_plane.h"
#include "model/scene.h"
#include "raster/texture_stage.h"
#include "rules/choices.h"

namespace edgecase {

// FastTextures: a scene's textures as kernels look them up, and where they can.
//
// They can where no vertex's w differs, so that one level of detail holds for all pixels of a
// triangle: the plain stages say which, once. Linear filters of RGBA8 texels whose images have
// sides of powers of two, repeated or clamped to the edge; everything else is left to the plain
// stages.
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

// FastScene: a scene made ready for the kernels, once for as often as it is drawn; what a vertex
// buffer is to OpenGL.
//
//   flat triangles and lines     integers alone: coverage and a code
//   smooth and textured ones     planes in double precision; where these leave a code open, the
//                                plain stages decide the pixel
//   all other primitives         the plain stages, primitive by primitive
//
// Of multisampled targets it takes flat triangles alone. Fragment operations and supersampling it
// leaves to raster/rasterizer.h.

// Primitives in a row that are drawn in the same way: `count` of those of their kind from `first`.
struct FastBatch {
  enum class Kind { flat_triangles, flat_lines, smooth_triangles, textured_triangles, plain };
  Kind kind = Kind::plain;
  std::size_t first = 0;
  std::size_t count = 0;
  PixelBounds bounds;           // of what may be drawn; maybe empty
  std::uint32_t samples = ~0U;  // bit s: sample s may be written
};

struct FastScene {
  std::vector<FastBatch> batches;
  std::vector<FlatTriangle> flat_triangles;
  std::vector<FlatLine> flat_lines;
  std::vector<SmoothTriangle> smooth_triangles;
  std::vector<ScenePrimitive> smooth_primitives;  // of smooth_triangles, one for one
  std::vector<TexturedTriangle> textured_triangles;
  std::vector<ScenePrimitive> textured_primitives;  // of these
  std::vector<ScenePrimitive> plain_primitives;
  std::unique_ptr<FastTextures> textures;  // null where the scene has none
};

// Nothing where the plain path has to draw. Refers to the scene and to the choices.
std::optional<FastScene> fast_scene(const Scene& scene, const RuleChoices& choices);

}  // namespace edgecase
