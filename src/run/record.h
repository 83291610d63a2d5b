// SPDX-License-Identifier: MIT
//
// Recording: every case of a suite rendered by one renderer, and its answers packed for a file.
//
// Cases are cut beforehand into blocks of about the same work, so that the file is the same
// whatever the number of threads. Each thread drives a renderer of its own, and packs what it
// renders.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "model/renderer.h"
#include "recording/recording.h"
#include "run/renderers.h"
#include "suite/selection.h"

namespace edgecase {

// RecordingRenderer: `recording:FILE`, a renderer that repeats the recorded answers of another one.
//
// It answers only the scenes that were recorded: a case that is not in the file, and one whose
// scene has changed, are Failures of kind `unavailable`. So a recording makes a machine's answers
// available on other machines, and never invents any.

bool is_recording(const std::string& renderer);

// The name under which known faults and profiles know a renderer: of a recording that can be read,
// that of the recorded renderer; otherwise the name itself.
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

struct RecordOptions {
  std::string tool;      // the program that records: "edgecase 0.1.0"
  std::string renderer;  // a name that make_renderer knows
  RendererOptions renderer_options;
  int jobs = 1;                                            // threads, at least 1
  std::function<void(std::size_t, std::size_t)> progress;  // done, total; from any thread; or empty
  // Becomes true when recording should end; put it into renderer_options as well.
  const std::atomic<bool>* stop = nullptr;
};

struct Recorded {
  std::string bytes;  // of the file
  RendererInfo renderer;
  std::size_t cases = 0;     // in the file
  std::size_t failures = 0;  // of them, those without a rendering
  bool is_complete = true;
  // Why the renderer could not be started; then there is no use in the file. Empty: it could.
  std::string unavailable;
};

// Records. Cases that were left out when `stop` became true are not in the file.
Recorded record_suite(const Suite& suite, const RecordOptions& options);

}  // namespace edgecase
