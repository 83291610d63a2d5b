// SPDX-License-Identifier: MIT
#include "raster/exact_renderer.h"

#include <utility>

#include "raster/rasterizer.h"

namespace edgecase {

ExactRenderer::ExactRenderer(Policy policy)
    : policy_(std::move(policy)),
      info_{.name = "exact",
            .vendor = "Edgecase",
            .version = "policy " + policy_.name,
            .device = "exact rasterizer",
            .subpixel_bits = Fixed::kFractionBits,
            .traits = {}} {}

void ExactRenderer::render(std::span<const Task> tasks, const OutcomeSink& sink) {
  for (std::size_t i = 0; i < tasks.size(); ++i) sink(i, rasterize(*tasks[i].scene, policy_));
}

}  // namespace edgecase
