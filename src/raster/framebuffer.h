// SPDX-License-Identifier: MIT
//
// Framebuffer: the pixels of scenes and nothing else, as fast as exact gets.
//
// What it draws is to the bit what raster/rasterizer.h puts into Rendering::pixels; of fragments,
// hits and samples it tells nothing. It is made once for a target and a policy, and draws any
// number of scenes; what it cannot draw it says when the scene is made ready
// (raster/exact_renderer.h then takes the plain path).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/policy.h"
#include "raster/fast_scene.h"

namespace edgecase {

class Framebuffer {
 public:
  // `reported`: as `rasterize` has it.
  Framebuffer(const Target& target, const ResolvedPolicy& policy,
              const SamplePositions& reported = {});
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  // Of a scene with this target, but for its clear colour. Nothing where the plain path has to
  // draw. Refers to the scene and to this.
  std::optional<FastScene> prepared(const Scene& scene) const;

  void clear(const Color& color);
  // On top of what is there.
  void draw(const FastScene& scene);
  // Makes pixels of samples; of a target that is not multisampled it does nothing.
  void resolve();

  // RGBA8, row by row from the bottom, 4 * width * height; as Rendering::pixels.
  std::vector<std::uint8_t> pixels() const;

 private:
  // Rows begin on a line of the cache, and one row's lines and the next one's share no sets of it:
  // a small triangle's rows would drive each other out where the width is a power of two.
  struct alignas(64) CacheLine {
    static constexpr std::size_t kPixels = 64 / sizeof(PixelWord);
    PixelWord pixels[kPixels];
  };

  std::size_t plane_size() const;
  class PlainWords;
  void draw_flat(const FastScene& scene, const FastBatch& batch);
  // By fill(plane, bounds, triangle, ties, doubtful).
  template <class Triangle, class Fill>
  void draw_interpolated(std::span<const Triangle> triangles,
                         std::span<const ScenePrimitive> primitives, const FastBatch& batch,
                         const FastScene& scene, Fill fill);
  void draw_plain(const ScenePrimitive& primitive, const FastScene& scene);

  Target target_;
  RuleChoices choices_;
  std::vector<RawPoint> places_;  // of the samples, within the pixel
  std::size_t stride_;            // pixels
  std::vector<std::vector<CacheLine>> memory_;
  std::vector<PixelPlane> planes_;  // one for each sample, then the resolved one
  std::vector<PixelPosition> doubtful_;
};

}  // namespace edgecase
