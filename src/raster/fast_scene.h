// SPDX-License-Identifier: MIT
//
// The input of the kernels: prepared textures and a prepared scene.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "kernels/color_planes.h"
#include "kernels/kernels.h"
#include "model/scene.h"
#include "raster/texture_stage.h"
#include "rules/choices.h"

namespace edgecase {

// FastTextures: a scene's textures, prepared for lookups by kernels where that is possible.
//
// It is possible if a triangle's vertices have equal w, so that one level of detail, computed once
// by the plain stages, holds for all its pixels. Filters must be linear, texels RGBA8, sides powers
// of two, and wrap modes repeat or clamp to edge. The plain stages do everything else.
class FastTextures {
 public:
  // Both arguments must outlive this object.
  FastTextures(const Scene& scene, const RuleChoices& choices);

  const TextureStage& stage() const { return stage_; }

  // The lookups of a textured triangle, without its positions, or nothing if the plain stages have
  // to do them. The vertices must have equal w or need no division by it. The planes live as long
  // as this object.
  std::optional<TexturedTriangle> looked_up(const ScenePrimitive& triangle);

 private:
  const TexelPlane* plane_of(std::size_t texture, int level);

  const Scene& scene_;
  const RuleChoices& choices_;
  TextureStage stage_;
  std::deque<std::vector<PixelWord>> words_;
  std::map<std::pair<std::size_t, int>, std::optional<TexelPlane>> planes_;
};

// FastScene: a scene prepared once for drawing with kernels, like a vertex buffer in OpenGL.
//
//   flat triangles and lines     integers alone: coverage and a code
//   smooth and textured ones     planes in double precision; where these leave a code open, the
//                                plain stages decide the pixel
//   all other primitives         the plain stages, primitive by primitive
//
// Of multisampled targets it supports flat triangles only. Fragment operations and supersampling
// are left to raster/rasterizer.h.

// Consecutive primitives drawn in the same way: `count` of their kind, starting at `first`.
struct FastBatch {
  enum class Kind { flat_triangles, flat_lines, smooth_triangles, textured_triangles, plain };
  Kind kind = Kind::plain;
  std::size_t first = 0;
  std::size_t count = 0;
  PixelBounds bounds;           // the pixels that may be written; possibly empty
  std::uint32_t samples = ~0U;  // bit s: sample s may be written
};

struct FastScene {
  std::vector<FastBatch> batches;
  std::vector<FlatTriangle> flat_triangles;
  std::vector<FlatLine> flat_lines;
  std::vector<SmoothTriangle> smooth_triangles;
  std::vector<ScenePrimitive> smooth_primitives;  // those of smooth_triangles, in the same order
  std::vector<TexturedTriangle> textured_triangles;
  std::vector<ScenePrimitive> textured_primitives;  // those of textured_triangles
  std::vector<ScenePrimitive> plain_primitives;
  std::unique_ptr<FastTextures> textures;  // null where the scene has none
};

// Nothing if the plain path has to draw. The result refers to the scene and to the choices.
std::optional<FastScene> fast_scene(const Scene& scene, const RuleChoices& choices);

}  // namespace edgecase
