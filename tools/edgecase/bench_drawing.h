// SPDX-License-Identifier: MIT
//
// ExactDrawing: the pixels of a scene by the exact rasterizer, over and over: what `edgecase bench`
// times on our side. Vertices are made ready beforehand, as OpenGL's are in buffers.
#pragma once

#include <cstdint>
#include <vector>

#include "model/policy.h"
#include "model/scene.h"
#include "raster/framebuffer.h"

namespace edgecase {

class ExactDrawing {
 public:
  // Scenes of one target that are drawn one above the other; all but the first cover it. They must
  // outlive the drawing.
  ExactDrawing(const std::vector<Scene>& layers, const Policy& policy);

  // Clears and draws all layers; by the plain rasterizer where the framebuffer cannot.
  void draw();

  // What was drawn, RGBA8, row by row from the bottom.
  std::vector<std::uint8_t> pixels() const;

 private:
  const std::vector<Scene>& layers_;
  const Policy& policy_;
  Framebuffer framebuffer_;
  std::vector<FastScene> prepared_;  // of all layers, or none
  std::vector<std::uint8_t> plain_pixels_;
};

}  // namespace edgecase
