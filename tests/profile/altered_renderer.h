// SPDX-License-Identifier: MIT
//
// A renderer to measure that follows a known policy and has known faults.
#pragma once

#include <functional>
#include <utility>

#include "model/policy.h"
#include "model/renderer.h"
#include "raster/rasterizer.h"

namespace edgecase {

using Alter = std::function<void(const Task&, Rendering&)>;

// Whether a scene is drawn. Empty: all are.
using IsDrawn = std::function<bool(const Task&)>;

// The exact rasterizer under a policy, with something put wrong. It refuses what is not drawn.
class AlteredRenderer final : public Renderer {
 public:
  AlteredRenderer(Policy policy, Alter alter, IsDrawn is_drawn = {})
      : policy_(std::move(policy)), alter_(std::move(alter)), is_drawn_(std::move(is_drawn)) {}
  const RendererInfo& info() const override {
    static const RendererInfo info{"altered", "", "", "altered", 8, {}};
    return info;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (is_drawn_ && !is_drawn_(tasks[i])) {
        sink(i, Failure{FailureKind::unsupported, "not this test's"});
        continue;
      }
      Rendering rendering = rasterize(*tasks[i].scene, policy_);
      if (alter_) alter_(tasks[i], rendering);
      sink(i, std::move(rendering));
    }
  }

 private:
  Policy policy_;
  Alter alter_;
  IsDrawn is_drawn_;
};

}  // namespace edgecase
