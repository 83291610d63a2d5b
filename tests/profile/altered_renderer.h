// SPDX-License-Identifier: MIT
//
// A renderer to measure that follows a known policy and has known faults.
#pragma once

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "model/policy.h"
#include "model/renderer.h"
#include "raster/rasterizer.h"

namespace edgecase {

using Alter = std::function<void(const Task&, Rendering&)>;

// The exact rasterizer under a policy, with something put wrong. It refuses scenes whose ids do not
// begin with one of `families`, if there are any.
class AlteredRenderer final : public Renderer {
 public:
  AlteredRenderer(Policy policy, Alter alter, std::vector<std::string_view> families = {})
      : policy_(std::move(policy)), alter_(std::move(alter)), families_(std::move(families)) {}
  const RendererInfo& info() const override {
    static const RendererInfo info{"altered", "", "", "altered", 8, {}};
    return info;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (!is_drawn(tasks[i].id)) {
        sink(i, Failure{FailureKind::unsupported, "not this test's"});
        continue;
      }
      Rendering rendering = rasterize(*tasks[i].scene, policy_);
      if (alter_) alter_(tasks[i], rendering);
      sink(i, std::move(rendering));
    }
  }

 private:
  bool is_drawn(std::string_view id) const {
    return families_.empty() ||
           std::any_of(families_.begin(), families_.end(),
                       [&](std::string_view family) { return id.starts_with(family); });
  }

  Policy policy_;
  Alter alter_;
  std::vector<std::string_view> families_;
};

}  // namespace edgecase
