// SPDX-License-Identifier: MIT
//
// A renderer that follows a known policy and has known faults.
#pragma once

#include <functional>
#include <utility>

#include "model/policy.h"
#include "model/renderer.h"
#include "raster/rasterizer.h"

namespace edgecase {

using Alter = std::function<void(const Task&, Rendering&)>;

// The exact rasterizer under a policy, with something put wrong.
class AlteredRenderer final : public Renderer {
 public:
  AlteredRenderer(Policy policy, Alter alter)
      : policy_(std::move(policy)), alter_(std::move(alter)) {}
  const RendererInfo& info() const override {
    static const RendererInfo info{"altered", "", "", "altered", 8, {}};
    return info;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      Rendering rendering = rasterize(*tasks[i].scene, policy_);
      if (alter_) alter_(tasks[i], rendering);
      sink(i, std::move(rendering));
    }
  }

 private:
  Policy policy_;
  Alter alter_;
};

}  // namespace edgecase
