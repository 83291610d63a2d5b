// SPDX-License-Identifier: MIT
//
// The exact rasterizer behind the Renderer interface, under one policy. It is what `--against
// exact` and `render --with exact` use; comparisons call rasterize themselves.
#pragma once

#include <span>

#include "model/policy.h"
#include "model/renderer.h"

namespace edgecase {

class ExactRenderer final : public Renderer {
 public:
  explicit ExactRenderer(Policy policy);
  const RendererInfo& info() const override { return info_; }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override;

 private:
  Policy policy_;
  RendererInfo info_;
};

}  // namespace edgecase
