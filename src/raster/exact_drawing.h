// SPDX-License-Identifier: MIT
//
// ExactDrawing: the pixels of scenes by the exact rasterizer, over and over. Here it is decided who
// draws them: the framebuffer where it can, the plain rasterizer else.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/policy.h"
#include "model/scene.h"
#include "raster/framebuffer.h"

namespace edgecase {

class ExactDrawing {
 public:
  // Scenes of one target that are drawn one above the other, at least one; all but the first cover
  // it. They must outlive the drawing. Vertices are made ready here, as OpenGL's are in buffers.
  ExactDrawing(std::span<const Scene> layers, const Policy& policy);

  // Clears and draws all layers.
  void draw();

  // What was drawn; of one layer this is Rendering::pixels of `rasterize`.
  std::vector<std::uint8_t> pixels() const;

 private:
  std::span<const Scene> layers_;
  const Policy& policy_;
  Framebuffer framebuffer_;
  std::vector<FastScene> prepared_;  // of all layers, or none
  std::vector<std::uint8_t> plain_pixels_;
};

}  // namespace edgecase
