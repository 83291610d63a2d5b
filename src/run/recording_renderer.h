// SPDX-License-Identifier: MIT
//
// RecordingRenderer: `recording:FILE`, a renderer that answers what another one answered before.
//
// It answers only the scenes that were recorded: a case that is not in the file, and one whose
// scene is another than it was, are Failures of kind `unavailable`. So a recording makes a
// machine's answers available where that machine is not, and never makes any up.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "model/renderer.h"
#include "recording/recording.h"

namespace edgecase {

bool is_recording(const std::string& renderer);

// The name under which known faults and profiles know a renderer: of a recording that can be read,
// that of the renderer which was recorded; else the name itself.
std::string known_name_of(const std::string& renderer);

// The recording that `renderer` names, or one sentence that says what is wrong with it.
std::variant<std::unique_ptr<Renderer>, std::string> open_recording(const std::string& renderer);

class RecordingRenderer final : public Renderer {
 public:
  // `name` is "recording:FILE".
  RecordingRenderer(std::string name, std::shared_ptr<const Recording> recording);

  // The recorded renderer's, but for the name.
  const RendererInfo& info() const override { return info_; }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override;

 private:
  Outcome replay(const Task& task);

  RendererInfo info_;
  std::shared_ptr<const Recording> recording_;
  // The block that was read last: cases mostly come in the order in which they are stored.
  std::size_t block_ = static_cast<std::size_t>(-1);
  std::vector<std::string> lines_;
};

}  // namespace edgecase
