// SPDX-License-Identifier: MIT
//
// A renderer that is also asked for the images of each scene (diff/invariance.h), and whose
// renderings say what was drawn otherwise there.
#pragma once

#include <memory>

#include "model/renderer.h"

namespace edgecase {

class InvariantRenderer final : public Renderer {
 public:
  // `suggested`: also for images of which the specification only suggests how they are drawn.
  explicit InvariantRenderer(std::unique_ptr<Renderer> inner, bool suggested = true)
      : inner_(std::move(inner)), suggested_(suggested) {}

  const RendererInfo& info() const override { return inner_->info(); }
  // An image that the renderer does not support, or that a recording lacks, is counted as refused.
  // If it fails otherwise, that is the outcome of the scene.
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override;
  std::uint64_t outcome_digest() const override { return digest_; }

 private:
  std::unique_ptr<Renderer> inner_;
  bool suggested_ = true;
  std::uint64_t digest_ = 0;  // of all outcomes of the latest scene
};

}  // namespace edgecase
