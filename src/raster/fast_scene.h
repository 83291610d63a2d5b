// SPDX-License-Identifier: MIT
//
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
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "kernels/color_planes.h"
#include "kernels/pixel_plane.h"
#include "model/scene.h"
#include "raster/fast_textures.h"
#include "rules/choices.h"

namespace edgecase {

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
