// SPDX-License-Identifier: MIT
//
// The exact rasterizer behind the Renderer interface, under one policy. It is what `--against
// exact` and `render --with exact` use; comparisons call rasterize themselves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/renderer.h"
#include "model/scene.h"
#include "raster/framebuffer.h"
#include "rules/choices.h"

namespace edgecase {

class ExactRenderer final : public Renderer {
 public:
  explicit ExactRenderer(const Policy& policy);
  const RendererInfo& info() const override { return info_; }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override;

 private:
  ResolvedPolicy policy_;
  RendererInfo info_;
};

// ExactDrawing: the pixels of scenes by the exact rasterizer, over and over. Here it is decided who
// draws them: the framebuffer where it can, the plain rasterizer else.
class ExactDrawing {
 public:
  // Scenes of one target that are drawn one above the other, at least one; all but the first cover
  // it. They must outlive the drawing. Vertices are made ready here, as OpenGL's are in buffers.
  ExactDrawing(std::span<const Scene> layers, const ResolvedPolicy& policy);

  // Clears and draws all layers.
  void draw();

  // What was drawn; of one layer this is Rendering::pixels of `rasterize`.
  std::vector<std::uint8_t> pixels() const;

 private:
  std::span<const Scene> layers_;
  const ResolvedPolicy policy_;
  Framebuffer framebuffer_;
  std::vector<FastScene> prepared_;  // of all layers, or none
  std::vector<std::uint8_t> plain_pixels_;
};

}  // namespace edgecase
