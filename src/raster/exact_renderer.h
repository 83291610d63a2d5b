// SPDX-License-Identifier: MIT
//
// The exact rasterizer behind the Renderer interface, under one policy, for `--against exact` and
// `render --with exact`. Comparisons call rasterize directly.
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

// ExactDrawing: draws scenes repeatedly with the exact rasterizer. It uses the framebuffer where
// that can draw them, and the plain rasterizer otherwise.
class ExactDrawing {
 public:
  // `layers`: at least one scene, all of one target, drawn on top of each other; all but the first
  // cover the target. They must outlive the drawing. Vertices are prepared here, as OpenGL's are in
  // buffers.
  ExactDrawing(std::span<const Scene> layers, const ResolvedPolicy& policy);

  // Clears and draws all layers.
  void draw();

  // The result. For a single layer it equals Rendering::pixels of `rasterize`.
  std::vector<std::uint8_t> pixels() const;

 private:
  std::span<const Scene> layers_;
  const ResolvedPolicy policy_;
  Framebuffer framebuffer_;
  std::vector<FastScene> prepared_;  // of all layers, or empty
  std::vector<std::uint8_t> plain_pixels_;
};

}  // namespace edgecase
