// SPDX-License-Identifier: MIT
//
// ProcessRenderer: a renderer that lives in a process of its own and speaks reference/PROTOCOL.md.
//
// Whatever the program does costs the scene at hand and no other: a crash, a hang and an answer
// that is no rendering are Failures, after which the program starts again. A program that cannot be
// started, says with exit status 3 that it cannot work here, or dies three times without ever
// answering anything, is unavailable for all scenes, and is not tried again.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "model/renderer.h"
#include "run/child_process.h"

namespace edgecase {

struct ProcessSpec {
  std::string name;  // as the command line names the renderer: "osmesa:llvmpipe"
  Command command;
  std::chrono::milliseconds timeout{10'000};          // from the request to the whole answer
  std::chrono::milliseconds startup_timeout{30'000};  // added for the very first answer
  std::chrono::milliseconds restart_timeout{5'000};   // added for the first one after a restart
  // Becomes true when nobody waits for answers any more: the scene at hand then fails as timed out,
  // and its outcome means nothing. Or null.
  const std::atomic<bool>* stop = nullptr;
};

class ProcessRenderer final : public Renderer {
 public:
  // Starts nothing: the program starts with the first scene.
  explicit ProcessRenderer(ProcessSpec spec);

  RendererInfo info() const override { return info_; }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override;

 private:
  Outcome render_one(const Task& task);
  bool start();
  Outcome attempt(const Task& task);
  Outcome read(const std::string& line, const std::string& digest, const Task& task);
  std::chrono::milliseconds patience() const;
  Failure failure_of(ChildProcess::Status status);
  bool answers_an_empty_scene();
  std::string quote_errors() const;

  ProcessSpec spec_;
  RendererInfo info_;
  std::unique_ptr<ChildProcess> child_;
  bool child_answered_ = false;  // this process has answered something
  bool ever_answered_ = false;   // any process has
  int silent_deaths_ = 0;        // processes in a row that ended or hung without any answer
  std::string unavailable_;      // why the program is not tried again; empty: it is
};

}  // namespace edgecase
