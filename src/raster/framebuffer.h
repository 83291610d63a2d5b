// SPDX-License-Identifier: MIT
//
// Framebuffer: draws only the pixels of scenes, as fast as exact can.
//
// Its pixels equal, to the bit, Rendering::pixels by raster/rasterizer.h; it reports no fragments,
// hits or samples. It is made once for a target and a policy, and draws any number of scenes.
// `prepared` returns nothing for a scene that it cannot draw; raster/rasterizer.h then takes
// the plain path.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "kernels/color_planes.h"
#include "kernels/kernels.h"
#include "model/policy.h"
#include "model/scene.h"
#include "raster/texture_stage.h"
#include "rules/choices.h"

namespace edgecase {

// The input of the kernels: prepared textures and a prepared scene.

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

class Framebuffer {
 public:
  // `reported` as for `rasterize`.
  Framebuffer(const Target& target, const ResolvedPolicy& policy,
              const SamplePositions& reported = {});
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  // Prepares a scene with this target; its clear colour may differ. Nothing if the plain path has
  // to draw. The result refers to the scene and to this object.
  std::optional<FastScene> prepared(const Scene& scene) const;

  void clear(const Color& color);
  // Draws on top of the present contents.
  void draw(const FastScene& scene);
  // Resolves samples into pixels; does nothing if the target is not multisampled.
  void resolve();

  // RGBA8, row by row from the bottom, 4 * width * height bytes, as in Rendering::pixels.
  std::vector<std::uint8_t> pixels() const;

 private:
  // Rows start on a cache line and span an odd number of lines. Otherwise, at a width that is a
  // power of two, a small triangle's rows would share a cache set and evict each other.
  struct alignas(64) CacheLine {
    static constexpr std::size_t kPixels = 64 / sizeof(PixelWord);
    PixelWord pixels[kPixels];
  };

  std::size_t plane_size() const;
  class PlainWords;
  void draw_flat(const FastScene& scene, const FastBatch& batch);
  // Draws by fill(plane, bounds, triangle, ties, doubtful).
  template <class Triangle, class Fill>
  void draw_interpolated(std::span<const Triangle> triangles,
                         std::span<const ScenePrimitive> primitives, const FastBatch& batch,
                         const FastScene& scene, Fill fill);
  void draw_plain(const ScenePrimitive& primitive, const FastScene& scene);

  Target target_;
  RuleChoices choices_;
  std::vector<RawPoint> places_;  // sample positions within the pixel
  std::size_t stride_;            // pixels
  std::vector<std::vector<CacheLine>> memory_;
  std::vector<PixelPlane> planes_;  // one per sample, then the resolved one if there are several
  std::vector<PixelPosition> doubtful_;
};

}  // namespace edgecase
