// SPDX-License-Identifier: MIT
#include "raster/exact_renderer.h"

#include <optional>
#include <utility>

#include "raster/rasterizer.h"

namespace edgecase {

ExactRenderer::ExactRenderer(const Policy& policy)
    : policy_(policy),
      info_{.name = "exact",
            .vendor = "Edgecase",
            .version = "policy " + policy.name,
            .device = "exact rasterizer",
            .subpixel_bits = Fixed::kFractionBits,
            .traits = {}} {}

void ExactRenderer::render(std::span<const Task> tasks, const OutcomeSink& sink) {
  for (std::size_t i = 0; i < tasks.size(); ++i) sink(i, rasterize(*tasks[i].scene, policy_));
}

ExactDrawing::ExactDrawing(std::span<const Scene> layers, const ResolvedPolicy& policy)
    : layers_(layers), policy_(policy), framebuffer_(layers.front().target, policy) {
  for (const Scene& layer : layers_) {
    std::optional<FastScene> prepared = framebuffer_.prepared(layer);
    if (!prepared) {
      prepared_.clear();
      return;
    }
    prepared_.push_back(std::move(*prepared));
  }
}

void ExactDrawing::draw() {
  if (prepared_.empty()) {
    for (const Scene& layer : layers_) plain_pixels_ = rasterize(layer, policy_).pixels;
    return;
  }
  framebuffer_.clear(layers_.front().target.clear);
  for (const FastScene& layer : prepared_) framebuffer_.draw(layer);
  framebuffer_.resolve();
}

std::vector<std::uint8_t> ExactDrawing::pixels() const {
  return prepared_.empty() ? plain_pixels_ : framebuffer_.pixels();
}

}  // namespace edgecase
