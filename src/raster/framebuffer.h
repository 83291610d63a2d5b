// SPDX-License-Identifier: MIT
//
// Framebuffer: draws only the pixels of scenes, as fast as exact can.
//
// Its pixels equal, to the bit, Rendering::pixels by raster/rasterizer.h; it reports no fragments,
// hits or samples. It is made once for a target and a policy, and draws any number of scenes.
// `prepared` returns nothing for a scene that it cannot draw; raster/rasterizer.h then takes
// the plain path.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/policy.h"
#include "raster/fast_scene.h"

namespace edgecase {

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
